#include "cases/app/valve_ramp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/app/oscillation.hpp"

namespace velum::cases {
namespace {

constexpr double steady = 1e-9;        // of the difference, from sample to sample
constexpr double look_around = 0.005;  // of the history, before and after a sample
constexpr double at_rest = 0.1;        // of a class, over that

/// A mean under way.
struct Mean {
  double sum = 0;
  int n = 0;
  void add(double value) { sum += value, ++n; }
  double value() const { return n > 0 ? sum / n : unknown; }
};

}  // namespace

ValveRamp valve_ramp(History const& history, ValveFacts const& facts)
{
  auto const& time = history.time;
  auto const gap = history.column("gap");
  ValveRamp ramp;
  for (std::size_t k = 1; k < time.size(); ++k) {
    double const before = difference(facts, time[k - 1]), now = difference(facts, time[k]);
    double const share = (facts.seals_at - gap[k - 1]) / (gap[k] - gap[k - 1]);
    bool const opens = gap[k - 1] <= facts.seals_at && gap[k] > facts.seals_at;
    bool const shuts = gap[k - 1] > facts.seals_at && gap[k] <= facts.seals_at;
    double const change = steady * std::max(std::abs(before), std::abs(now));
    if (opens && now - before > change && std::isnan(ramp.cracks))
      ramp.cracks = std::lerp(before, now, share);
    if (shuts && before - now > change) ramp.reseats = std::lerp(before, now, share);
  }
  ramp.hysteresis = ramp.cracks - ramp.reseats;
  return ramp;
}

std::vector<KvClass> kv_over_lift(History const& history, ValveFacts const& facts, int classes)
{
  auto const& time = history.time;
  auto const gap = history.column("gap"), flow = history.column("flow");
  double const most = *std::max_element(gap.begin(), gap.end());
  if (most <= facts.seals_at) return {};
  double const width = (most - facts.seals_at) / classes;
  double const around = look_around * (time.back() - time.front());
  std::vector<Mean> opening(static_cast<std::size_t>(classes)), closing = opening;
  for (std::size_t k = 0; k < time.size(); ++k) {
    double const pressure = difference(facts, time[k]);
    if (gap[k] <= facts.seals_at || pressure <= 0) continue;
    auto const n =
        std::min(static_cast<std::size_t>((gap[k] - facts.seals_at) / width), opening.size() - 1);
    double const change = at_time(time, gap, std::min(time[k] + around, time.back())) -
                          at_time(time, gap, std::max(time[k] - around, time.front()));
    double const value = kv(flow[k], pressure, facts.density);
    if (change > -at_rest * width) opening[n].add(value);
    if (change < at_rest * width) closing[n].add(value);
  }
  std::vector<KvClass> all;
  for (std::size_t n = 0; n < opening.size(); ++n)
    all.push_back(
        {facts.seals_at + (double(n) + 0.5) * width, opening[n].value(), closing[n].value()});
  return all;
}

std::vector<core::Figure> figures(ValveRamp const& ramp)
{
  std::vector<core::Figure> all;
  for (auto const& [name, value] : {std::pair{"valve_cracking_pressure", ramp.cracks},
                                    {"valve_reseating_pressure", ramp.reseats},
                                    {"valve_hysteresis", ramp.hysteresis}})
    if (!std::isnan(value)) all.push_back({name, value, "Pa"});
  return all;
}

std::string ramp_text(ValveRamp const& ramp)
{
  std::string text;
  for (auto const& [name, value] : {std::pair{"cracks at a rising difference of", ramp.cracks},
                                    {"reseats at a falling one of", ramp.reseats},
                                    {"hysteresis", ramp.hysteresis}})
    if (!std::isnan(value)) text += fmt::format("  {:<34} {:.4g} kPa\n", name, value / 1e3);
  return text;
}

std::string csv(std::vector<KvClass> const& classes)
{
  std::string text = "gap [m],kv_opening [m3/h],kv_closing [m3/h]\n";
  auto const cell = [](double value) {
    return std::isnan(value) ? std::string() : fmt::format("{:.6g}", value);
  };
  for (auto const& c : classes)
    text += fmt::format("{:.6g},{},{}\n", c.gap, cell(c.opening), cell(c.closing));
  return text;
}

}  // namespace velum::cases
