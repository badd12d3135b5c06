#include "cases/app/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

#include "cases/app/curve.hpp"

namespace velum::cases {
namespace {

using Complex = std::complex<double>;
constexpr double two_pi = 2 * std::numbers::pi;
constexpr std::size_t padding = 4;

double mean_of(std::vector<double> const& value)
{
  return std::accumulate(value.begin(), value.end(), 0.0) / double(value.size());
}

double hann(std::size_t k, std::size_t size)
{
  return 1 - std::cos(two_pi * (double(k) + 0.5) / double(size));
}

}  // namespace

double median_step(std::vector<double> const& time)
{
  std::vector<double> steps;
  for (std::size_t k = 1; k < time.size(); ++k) steps.push_back(time[k] - time[k - 1]);
  auto const middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

EvenSignal resample(std::vector<double> const& time, std::vector<double> const& value, double step)
{
  EvenSignal even{time.front(), step, {}};
  Curve const curve{time, value};
  auto const steps = static_cast<std::size_t>((time.back() - time.front()) / step * (1 + 1e-12));
  for (std::size_t k = 0; k <= steps; ++k) even.value.push_back(value_at(curve, even.time(k)));
  return even;
}

std::vector<Complex> hann_mean(std::vector<Complex> const& value, std::size_t half)
{
  // Sums up to each place, plain and times exp(i pi m / half): any window is a difference of them.
  std::size_t const size = value.size();
  std::vector<Complex> plain(size + 1), ahead(size + 1), back(size + 1);
  auto const turn = [&](std::size_t m) {
    return std::polar(1.0, std::numbers::pi * double(m % (2 * half)) / double(half));
  };
  for (std::size_t m = 0; m < size; ++m) {
    plain[m + 1] = plain[m] + value[m];
    ahead[m + 1] = ahead[m] + value[m] * turn(m);
    back[m + 1] = back[m] + value[m] * std::conj(turn(m));
  }
  std::vector<Complex> mean(size);
  for (std::size_t n = half; n + half < size; ++n) {
    std::size_t const a = n - half, b = n + half;
    mean[n] = (plain[b] - plain[a] +
               0.5 * ((ahead[b] - ahead[a]) * std::conj(turn(n)) + (back[b] - back[a]) * turn(n))) /
              (2.0 * double(half));
  }
  std::size_t const last = size - 1 - half;
  for (std::size_t n = 0; n < half; ++n) mean[n] = mean[half];
  for (std::size_t n = last + 1; n < size; ++n) mean[n] = mean[last];
  return mean;
}

std::vector<double> slow_mean(std::vector<double> const& value, std::size_t half)
{
  auto const mean = hann_mean({value.begin(), value.end()}, half);
  std::vector<double> slow;
  for (auto const& m : mean) slow.push_back(m.real());
  std::size_t const last = value.size() - 1 - half;
  if (last < 2 * half) return slow;  // nothing tells a slope
  double const in = (slow[2 * half] - slow[half]) / double(half);
  double const out = (slow[last] - slow[last - half]) / double(half);
  for (std::size_t n = 0; n < half; ++n) slow[n] -= in * double(half - n);
  for (std::size_t n = last + 1; n < value.size(); ++n) slow[n] += out * double(n - last);
  return slow;
}

Spectrum hann_spectrum(EvenSignal const& signal)
{
  std::size_t const size = signal.value.size();
  std::size_t length = 1;
  while (length < padding * size) length *= 2;
  double const mean = mean_of(signal.value);
  std::vector<double> windowed(length);
  for (std::size_t k = 0; k < size; ++k) windowed[k] = hann(k, size) * (signal.value[k] - mean);
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<Complex> transform;
  fft.fwd(transform, windowed);
  Spectrum spectrum{1 / (signal.step * double(length)), {}};
  for (auto const& t : transform) spectrum.power.push_back(std::norm(2.0 * t / double(size)));
  return spectrum;
}

double peak_frequency(Spectrum const& spectrum, double least)
{
  auto const& p = spectrum.power;
  auto const first = std::min(p.size() - 1, static_cast<std::size_t>(least / spectrum.step));
  auto const top = static_cast<std::size_t>(
      std::max_element(p.begin() + static_cast<std::ptrdiff_t>(first), p.end()) - p.begin());
  double shift = 0;
  if (top > 0 && top + 1 < p.size() && p[top - 1] > 0 && p[top + 1] > 0) {
    double const a = std::log(p[top - 1]), b = std::log(p[top]), c = std::log(p[top + 1]);
    if (double const bend = a - 2 * b + c; bend < 0) shift = (a - c) / (2 * bend);
  }
  return spectrum.step * (double(top) + shift);
}

Complex component(EvenSignal const& signal, double frequency)
{
  std::size_t const size = signal.value.size();
  double const mean = mean_of(signal.value);
  Complex sum = 0;
  for (std::size_t k = 0; k < size; ++k)
    sum += hann(k, size) * (signal.value[k] - mean) *
           std::polar(1.0, -two_pi * std::fmod(frequency * signal.time(k), 1.0));
  return 2.0 * sum / double(size);
}

}  // namespace velum::cases
