#include "cases/app/swing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace velum::cases {
namespace {

constexpr double turn_from = 0.3;  // of the amplitude: what counts as a turn of the swing

std::size_t period_samples(EvenSignal const& signal, double frequency)
{
  return static_cast<std::size_t>(std::lround(1 / (frequency * signal.step)));
}

}  // namespace

EvenSignal about_slow_mean(EvenSignal signal, std::size_t half)
{
  auto const slow = slow_mean(signal.value, half);
  for (std::size_t k = 0; k < slow.size(); ++k) signal.value[k] -= slow[k];
  return signal;
}

Swing swing_at(EvenSignal const& signal, double frequency)
{
  std::size_t const half =
      std::min(period_samples(signal, frequency), (signal.value.size() - 1) / 2);
  Swing s{about_slow_mean(signal, half), {}, half};
  std::vector<std::complex<double>> turned;
  for (std::size_t k = 0; k < signal.value.size(); ++k)
    turned.push_back(2 * s.about_mean.value[k] *
                     std::polar(1.0, -2 * std::numbers::pi * frequency * signal.step * double(k)));
  for (auto const& z : hann_mean(turned, half)) s.amplitude.push_back(std::abs(z));
  return s;
}

Span longest_span(Swing const& s, double threshold)
{
  Span best, now;
  for (std::size_t k = 0; k < s.amplitude.size(); ++k) {
    if (s.amplitude[k] <= threshold) continue;
    if (now.end == 0 || k > now.end + 2 * s.half) now = {k, k};
    now.end = k + 1;
    if (now.end - now.begin > best.end - best.begin) best = now;
  }
  return best;
}

EvenSignal part(EvenSignal const& signal, Span span)
{
  auto const from = signal.value.begin();
  return {signal.time(span.begin),
          signal.step,
          {from + static_cast<std::ptrdiff_t>(span.begin),
           from + static_cast<std::ptrdiff_t>(span.end)}};
}

double count_cycles(Swing const& s, Span span)
{
  int side = 0, turns = 0;
  for (std::size_t k = span.begin; k < span.end; ++k) {
    double const x = s.about_mean.value[k];
    if (std::abs(x) < turn_from * s.amplitude[k]) continue;
    int const now = x > 0 ? 1 : -1;
    if (now != side) ++turns;
    side = now;
  }
  return std::max(0, turns - 1) / 2.0;
}

double log_rate(Swing const& s, std::size_t begin, std::size_t end)
{
  double const n = double(end - begin), middle = (n - 1) / 2;
  double product = 0, square = 0;
  for (std::size_t k = begin; k < end; ++k) {
    double const t = double(k - begin) - middle;
    product += t * std::log(std::max(s.amplitude[k], std::numeric_limits<double>::min()));
    square += t * t;
  }
  return square > 0 ? product / square / s.about_mean.step : 0;
}

}  // namespace velum::cases
