#pragma once
#include <complex>
#include <cstddef>
#include <vector>

/// Evenly sampled signals and what is in them.
namespace velum::cases {

/// A signal at begin, begin + step, ...
struct EvenSignal {
  double begin, step;
  std::vector<double> value;

  double time(std::size_t k) const { return begin + step * double(k); }
};

/// Median distance of samples.
/// @pre at least two
double median_step(std::vector<double> const& time);

/// Samples, unevenly spaced, put on even ones from the first to the last, straight between them.
/// Without a filter before: what is faster than half the new rate folds back.
EvenSignal resample(std::vector<double> const& time, std::vector<double> const& value, double step);

/// Moving mean with the weights 1 + cos(pi j / half), |j| < half, a Hann window (Harris 1978,
/// doi:10.1109/PROC.1978.10837). Of the sampling rate it takes out the frequencies n / (2 half),
/// n > 1. The first and last `half` values hold those beside them.
/// @pre 2 half < size
std::vector<std::complex<double>> hann_mean(std::vector<std::complex<double>> const& value,
                                            std::size_t half);

/// What a signal does slowly beside an oscillation of `half` samples a period: its hann_mean() over
/// two periods, where the oscillation and all its harmonics vanish; continued straight at both
/// ends.
std::vector<double> slow_mean(std::vector<double> const& value, std::size_t half);

/// Power over frequency of a signal less its mean, under a Hann window, zeros added to at least
/// four times its length.
struct Spectrum {
  double step;                // Hz between the values, the first at 0
  std::vector<double> power;  // square of the amplitude of a sine at that frequency
};
Spectrum hann_spectrum(EvenSignal const& signal);

/// The largest power at or above a frequency, on the parabola through the logarithms beside it.
double peak_frequency(Spectrum const& spectrum, double least);

/// Amplitude and phase at the time 0 of a signal's part at a frequency, under a Hann window:
/// A exp(i phi) of A cos(2 pi f t + phi).
std::complex<double> component(EvenSignal const& signal, double frequency);

}  // namespace velum::cases
