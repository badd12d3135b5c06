#include "cases/app/chatter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "cases/app/oscillation.hpp"
#include "cases/app/spectrum.hpp"
#include "cases/app/swing.hpp"

namespace velum::cases {
namespace {

using Complex = std::complex<double>;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t fewest_samples = 32, candidates = 8;
constexpr double samples_per_period = 5, periods_in_record = 2;
constexpr double band = 0.2;  // of a frequency, to either side of it and its harmonics
constexpr double harmonics = 3;
constexpr double begun_cycles = 2;  // that tell an oscillation from a transient

Chatter nothing(ChatterKind kind)
{
  return {kind,    0,       unknown, unknown, unknown, unknown,
          unknown, unknown, unknown, unknown, unknown, unknown};
}

/// Share of the power that lies beside a frequency and its first harmonics: a gap that strikes its
/// seat is no sine.
double share_near(Spectrum const& spectrum, double frequency)
{
  double near = 0, all = 0;
  for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
    double const order = spectrum.step * double(k) / frequency, nearest = std::round(order);
    all += spectrum.power[k];
    if (nearest >= 1 && nearest <= harmonics && std::abs(order - nearest) <= band)
      near += spectrum.power[k];
  }
  return all > 0 ? near / all : 0;
}

/// The strongest frequencies of a signal's velocity, which the slow part does not hide.
std::vector<double> strongest(EvenSignal const& signal)
{
  EvenSignal velocity{signal.begin, signal.step, {}};
  for (std::size_t k = 1; k < signal.value.size(); ++k)
    velocity.value.push_back(signal.value[k] - signal.value[k - 1]);
  auto const spectrum = hann_spectrum(velocity);
  auto const& p = spectrum.power;
  double const lowest = periods_in_record / (signal.step * double(signal.value.size() - 1));
  double const highest = 1 / (samples_per_period * signal.step);
  std::vector<std::size_t> tops;
  for (std::size_t k = 1; k + 1 < p.size(); ++k) {
    double const f = spectrum.step * double(k);
    if (f >= lowest && f <= highest && p[k] > p[k - 1] && p[k] >= p[k + 1]) tops.push_back(k);
  }
  std::sort(tops.begin(), tops.end(), [&](auto a, auto b) { return p[a] > p[b]; });
  tops.resize(std::min(tops.size(), candidates));
  std::vector<double> frequencies;
  for (auto k : tops) frequencies.push_back(spectrum.step * double(k));
  return frequencies;
}

double degrees(Complex a) { return std::arg(a) * 180 / std::numbers::pi; }

double count_contacts(ChatterSignals const& s, double begin, double end)
{
  double contacts = 0;
  for (std::size_t k = 1; k < s.time.size(); ++k)
    if (s.time[k] > begin && s.time[k] <= end && s.gap[k - 1] > 0 && s.gap[k] <= 0) ++contacts;
  return contacts;
}

struct Found {
  double frequency, cycles;
  Swing swing;
  Span span;
};

/// The oscillation near a frequency, if the gap has one there; its cycles may be too few.
std::optional<Found> examine(EvenSignal const& gap, double frequency, ChatterRule const& rule)
{
  double const first = frequency;
  for (int pass = 0; pass < 2; ++pass) {
    auto const swing = swing_at(gap, frequency);
    Span const span = longest_span(swing, rule.threshold);
    if (span.end - span.begin < 2 * swing.half) return {};
    auto const spectrum = hann_spectrum(part(swing.about_mean, span));
    double const corrected = peak_frequency(spectrum, 0);
    if (std::abs(corrected / first - 1) > band) return {};
    if (pass == 1) {
      double const cycles = count_cycles(swing, span);
      double const expected = frequency * gap.step * double(span.end - span.begin);
      // A few cycles have no sharp line.
      double const needed = cycles < rule.fewest_cycles ? rule.share / 2 : rule.share;
      if (share_near(spectrum, corrected) < needed || cycles < 0.7 * expected) return {};
      return Found{corrected, cycles, swing, span};
    }
    frequency = corrected;
  }
  return {};
}

Chatter describe(Found const& found, ChatterSignals const& signals, ChatterRule const& rule)
{
  auto const& [frequency, cycles, swing, span] = found;
  auto const& about = swing.about_mean;
  Chatter c = nothing(ChatterKind::limit_cycle);
  c.frequency = frequency;
  c.cycles = cycles;
  c.onset = about.time(span.begin);
  c.end = about.time(span.end - 1);
  c.largest = 2 * *std::max_element(swing.amplitude.begin() + std::ptrdiff_t(span.begin),
                                    swing.amplitude.begin() + std::ptrdiff_t(span.end));

  // Near the ends of the record the amplitude is held, not known.
  std::size_t const from = std::max(span.begin, swing.half);
  std::size_t const to = std::min(span.end, swing.amplitude.size() - swing.half);
  std::size_t const later = to > from ? (from + to) / 2 : span.begin;
  c.rate = log_rate(swing, later, to > from ? to : span.end);
  double const change = c.rate * about.step * double((to > from ? to : span.end) - later);
  if (change > std::log1p(rule.steady_change)) c.kind = ChatterKind::growing;
  if (change < std::log1p(-rule.steady_change)) c.kind = ChatterKind::decaying;

  std::vector<double> time, upper, lower;
  for (std::size_t k = span.begin; k < span.end; ++k) {
    time.push_back(about.time(k));
    upper.push_back(about.value[k]);
    lower.push_back(-about.value[k]);
  }
  double const period = 1 / frequency;
  c.amplitude = 0;
  constexpr int last = 3;
  for (int n = 0; n < last; ++n) {
    double const end = c.end - n * period;
    c.amplitude +=
        (largest(time, upper, end - period, end) + largest(time, lower, end - period, end)) / last;
  }
  auto const part_of = [&](std::vector<double> const& value) {
    auto const even = resample(signals.time, value, about.step);
    return component(part(about_slow_mean(even, swing.half), span), frequency);
  };
  Complex const gap = component(part(about, span), frequency);
  Complex const pressure = part_of(signals.pressure), flow = part_of(signals.flow);
  c.pressure_phase = std::abs(pressure) > 0 ? degrees(pressure / gap) : unknown;
  c.flow_phase = std::abs(flow) > 0 ? degrees(flow / gap) : unknown;
  c.flow_pressure = std::abs(flow * pressure) > 0 ? degrees(flow / pressure) : unknown;
  c.contacts_per_cycle = count_contacts(signals, c.onset, c.end) / (frequency * (c.end - c.onset));
  return c;
}

}  // namespace

Chatter find_chatter(ChatterSignals const& signals, ChatterRule const& rule)
{
  if (signals.time.size() < fewest_samples) return nothing(ChatterKind::too_short);
  auto const gap = resample(signals.time, signals.gap, median_step(signals.time));
  if (gap.value.size() < fewest_samples) return nothing(ChatterKind::too_short);
  Chatter answer = nothing(ChatterKind::none);
  for (double const frequency : strongest(gap)) {
    auto const found = examine(gap, frequency, rule);
    if (!found) continue;
    if (found->cycles >= rule.fewest_cycles) return describe(*found, signals, rule);
    bool const goes_on = found->span.end + found->swing.half >= gap.value.size();
    if (!goes_on || found->cycles < begun_cycles) continue;
    answer.kind = ChatterKind::too_short;
    answer.cycles = std::max(answer.cycles, found->cycles);
  }
  return answer;
}

}  // namespace velum::cases
