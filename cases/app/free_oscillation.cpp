#include "cases/app/free_oscillation.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "cases/app/spectrum.hpp"

namespace velum::cases {
namespace {

constexpr double least_periods = 2;  // in each half

/// A half of a signal: its first or its second.
EvenSignal half(EvenSignal const& signal, bool second)
{
  auto const size = signal.value.size() / 2;
  auto const from = signal.value.begin() + std::ptrdiff_t(second ? size : 0);
  return {signal.time(second ? size : 0), signal.step, {from, from + std::ptrdiff_t(size)}};
}

/// The last two thirds, evenly sampled.
EvenSignal late(std::vector<double> const& time, std::vector<double> const& value)
{
  double const from = time.front() + (time.back() - time.front()) / 3;
  std::size_t first = 0;
  while (time[first] < from) ++first;
  std::vector<double> const t(time.begin() + std::ptrdiff_t(first), time.end());
  return resample(t, {value.begin() + std::ptrdiff_t(first), value.end()}, median_step(t));
}

}  // namespace

std::vector<core::Figure> free_oscillation(History const& history)
{
  if (!history.has("centre") || history.time.size() < 48) return {};
  EvenSignal const signal = late(history.time, history.column("centre"));
  double const apart = signal.step * double(signal.value.size() / 2);
  double const line = peak_frequency(hann_spectrum(signal), 1 / apart);
  if (!(line * apart >= least_periods)) return {};
  auto const first = component(half(signal, false), line),
             second = component(half(signal, true), line);
  if (!(std::abs(first) > 0 && std::abs(second) > 0)) return {};
  double const two_pi = 2 * std::numbers::pi;
  double const frequency = line + std::arg(second / first) / (two_pi * apart);
  return {{"free_frequency", frequency, "Hz"},
          {"free_damping_ratio",
           std::log(std::abs(first) / std::abs(second)) / (two_pi * frequency * apart), "1"}};
}

}  // namespace velum::cases
