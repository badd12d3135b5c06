#include "cases/app/valve_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cases/app/oscillation.hpp"

namespace velum::cases {
namespace {

constexpr double final_share = 0.1;    // of the time, at its end
constexpr double chamber_band = 0.05;  // of the final pressure
constexpr double least_rise = 0.05;    // of the largest flow, for a flow to rise at all
constexpr double lift_begins = 0.01;   // of its whole rise
constexpr double lift_rests = 1e-6;    // of its whole rise
constexpr double bar = 1e5, water = 1000, hour = 3600;
constexpr double inch = 25.4e-3, psi = 6894.76, millilitre_per_minute = 1e-6 / 60;
constexpr double class_v = 5e-4 * millilitre_per_minute / (inch * psi);  // m3/s per m and Pa

/// First time from `from` on at which a signal exceeds a level, straight between the samples.
double first_above(std::vector<double> const& time, std::vector<double> const& value, double level,
                   double from = -std::numeric_limits<double>::infinity())
{
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (time[k] < from || value[k] <= level) continue;
    if (k == 0 || value[k - 1] > level) return std::max(time[k], from);
    double const share = (level - value[k - 1]) / (value[k] - value[k - 1]);
    return std::max(from, std::lerp(time[k - 1], time[k], share));
  }
  return unknown;
}

/// Time at which the first of the lifts has risen by more than a share of its whole rise.
double first_rise(History const& history, double share)
{
  double first = unknown;
  for (auto const& column : history.columns) {
    if (!column.name.starts_with("lift_")) continue;
    auto const lift = history.column(column.name);
    double const whole = *std::max_element(lift.begin(), lift.end()) - lift.front();
    if (whole <= 0) continue;
    first = std::fmin(first, first_above(history.time, lift, lift.front() + share * whole));
  }
  return first;
}

/// Time from which on a signal stays within a band about a value.
double settles(std::vector<double> const& time, std::vector<double> const& value, double final,
               double band)
{
  auto const off = [&](std::size_t k) { return std::abs(value[k] - final) - band; };
  std::size_t k = time.size();
  while (k > 0 && off(k - 1) <= 0) --k;
  if (k == 0) return time.front();
  if (k == time.size()) return unknown;
  return std::lerp(time[k - 1], time[k], off(k - 1) / (off(k - 1) - off(k)));
}

/// Rows in which the valve is shut, while the pilot has not moved.
struct Shut {
  std::vector<double> time, flow;
};
Shut shut_rows(History const& history, ValveFacts const& facts, double pilot_opens)
{
  double const moves = std::fmin(pilot_opens, first_rise(history, lift_rests));
  auto const gap = history.column("gap"), flow = history.column("flow");
  Shut shut;
  for (std::size_t k = 0; k < gap.size() && gap[k] <= facts.seals_at; ++k) {
    if (history.time[k] > moves) break;  // never where it is not a number
    shut.time.push_back(history.time[k]);
    shut.flow.push_back(flow[k]);
  }
  return shut;
}

}  // namespace

double leak_class(double leak, double difference, double open_flow, double seat_diameter)
{
  double const size = std::abs(leak);
  if (seat_diameter > 0 && size <= class_v * seat_diameter * difference) return 5;
  if (!(open_flow > 0)) return unknown;
  double const share = size / open_flow;
  return share <= 1e-4 ? 4 : share <= 1e-3 ? 3 : share <= 5e-3 ? 2 : 1;
}

double difference(ValveFacts const& facts, double time)
{
  return value_at(facts.inlet, time) - value_at(facts.outlet, time);
}

double kv(double flow, double pressure, double density)
{
  return pressure > 0 ? hour * flow * std::sqrt(density / water / (pressure / bar)) : unknown;
}

ValveSheet valve_sheet(History const& history, ValveFacts const& facts)
{
  auto const& time = history.time;
  auto const gap = history.column("gap"), flow = history.column("flow");
  auto const chamber = history.column("pressure_above");
  auto const inside = history.column("pressure_inside");
  double const end = time.back();
  double const late = end - final_share * (end - time.front());
  auto const final_of = [&](auto const& value) { return mean(time, value, late, end); };

  ValveSheet s;
  s.pilot_opens = facts.pilot_opens.value_or(first_rise(history, lift_begins));
  double const start = std::isnan(s.pilot_opens) ? time.front() : s.pilot_opens;
  s.opens = first_above(time, gap, facts.seals_at);
  s.chamber_final = final_of(chamber);
  double const band = chamber_band * std::abs(s.chamber_final);
  s.chamber_time = std::fdim(settles(time, chamber, s.chamber_final, band), s.pilot_opens);
  s.flow_final = final_of(flow);
  s.flow_end = flow.back();
  auto const most = std::max_element(flow.begin(), flow.end());
  s.flow_largest = *most;
  double const before = at_time(time, flow, start), rise = s.flow_final - before;
  s.flow_rise = rise > least_rise * s.flow_largest
                    ? first_above(time, flow, before + 0.9 * rise, start) -
                          first_above(time, flow, before + 0.1 * rise, start)
                    : unknown;
  s.gap_final = final_of(gap);
  s.gap_end = gap.back();
  s.gap_largest = *std::max_element(gap.begin(), gap.end());

  double const pressure = difference(facts, end);
  s.kv = kv(s.flow_final, pressure, facts.density);
  s.pressure_least = *std::min_element(inside.begin(), inside.end());
  s.cell_least = unknown;
  if (history.has("pressure_least")) {
    auto const least = history.column("pressure_least");
    s.cell_least = *std::min_element(least.begin(), least.end());
  }
  s.cavitation =
      pressure > 0
          ? (value_at(facts.outlet, end) + facts.atmosphere - facts.vapour_pressure) / pressure
          : unknown;

  s.leak = s.leak_class = unknown;
  auto const shut = shut_rows(history, facts, s.pilot_opens);
  if (shut.time.size() < 3) return s;
  double const until = shut.time.back();
  s.leak = mean(shut.time, shut.flow, (shut.time.front() + until) / 2, until);
  double const at_most = difference(facts, time[static_cast<std::size_t>(most - flow.begin())]);
  double const open_flow = s.gap_largest > facts.seals_at && at_most > 0
                               ? s.flow_largest * std::sqrt(difference(facts, until) / at_most)
                               : 0;
  s.leak_class = leak_class(s.leak, difference(facts, until), open_flow, facts.seat_diameter);
  return s;
}

}  // namespace velum::cases
