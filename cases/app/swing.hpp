#pragma once
#include "cases/app/spectrum.hpp"

namespace velum::cases {

/// A signal as it oscillates about its slow mean, with the amplitude of what it does near one
/// frequency f: 2 |hann_mean(signal exp(-2 pi i f t))| over two periods.
struct Swing {
  EvenSignal about_mean;
  std::vector<double> amplitude;
  std::size_t half;  // samples in a period
};
/// @pre at least three samples; a period that is longer than half the signal is taken as that
Swing swing_at(EvenSignal const& signal, double frequency);

/// A signal less its slow_mean().
EvenSignal about_slow_mean(EvenSignal signal, std::size_t half);

/// Samples [begin, end).
struct Span {
  std::size_t begin = 0, end = 0;
};

/// The longest stretch with an amplitude above the threshold; pauses of two periods do not end it.
Span longest_span(Swing const& swing, double threshold);

/// The samples of a span.
EvenSignal part(EvenSignal const& signal, Span span);

/// Whole and half cycles that the swing goes through, from its first turn to its last.
double count_cycles(Swing const& swing, Span span);

/// Slope of ln(amplitude) over time by least squares, over [begin, end), 1/s.
double log_rate(Swing const& swing, std::size_t begin, std::size_t end);

}  // namespace velum::cases
