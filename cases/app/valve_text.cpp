#include <fmt/format.h>

#include <cmath>

#include "cases/app/valve_figures.hpp"

namespace velum::cases {

std::vector<core::Figure> figures(ValveSheet const& s)
{
  return {{"valve_pilot_opens", s.pilot_opens, "s"},
          {"valve_opens", s.opens, "s"},
          {"valve_chamber_pressure_final", s.chamber_final, "Pa"},
          {"valve_chamber_pressure_time", s.chamber_time, "s"},
          {"valve_flow_final", s.flow_final, "m3/s"},
          {"valve_flow_end", s.flow_end, "m3/s"},
          {"valve_flow_max", s.flow_largest, "m3/s"},
          {"valve_flow_rise_time", s.flow_rise, "s"},
          {"valve_gap_final", s.gap_final, "m"},
          {"valve_gap_end", s.gap_end, "m"},
          {"valve_gap_max", s.gap_largest, "m"},
          {"valve_kv", s.kv, "m3/h"},
          {"valve_leak_shut", s.leak, "m3/s"},
          {"valve_leak_class", s.leak_class, "1"},
          {"valve_pressure_inside_min", s.pressure_least, "Pa"},
          {"valve_pressure_cell_min", s.cell_least, "Pa"},
          {"valve_cavitation_number", s.cavitation, "1"}};
}

std::string valve_text(ValveSheet const& s)
{
  constexpr double litres_per_hour = 3.6e6;
  constexpr char const* classes[] = {"I", "II", "III", "IV", "V"};
  std::string t = "Valve\n";
  auto const row = [&](std::string const& name, std::string const& value) {
    t += fmt::format("  {:<34} {}\n", name, value);
  };
  auto const ms = [](double seconds) { return fmt::format("{:.4g} ms", 1e3 * seconds); };
  auto const known = [](double value) { return !std::isnan(value); };
  if (known(s.pilot_opens)) row("pilot opens at", ms(s.pilot_opens));
  row("leaves its seat at", known(s.opens) ? ms(s.opens) : "never");
  // of what is still under way a mean over the last tenth alone would be believed to be the end
  row("pressure above, last tenth",
      fmt::format("{:.4g} kPa{}", s.chamber_final / 1e3,
                  known(s.chamber_time) ? ", within 5 % after " + ms(s.chamber_time) : ""));
  row("flow, last tenth", fmt::format("{:.4g} l/h, at the end {:.4g} l/h, at most {:.4g} l/h",
                                      litres_per_hour * s.flow_final, litres_per_hour * s.flow_end,
                                      litres_per_hour * s.flow_largest));
  if (known(s.flow_rise)) row("rise of the flow, 10 to 90 %", ms(s.flow_rise));
  row("gap, last tenth", fmt::format("{:.3g} um, at the end {:.3g} um, at most {:.3g} um",
                                     1e6 * s.gap_final, 1e6 * s.gap_end, 1e6 * s.gap_largest));
  if (known(s.kv)) row("Kv, last tenth", fmt::format("{:.4g} m3/h", s.kv));
  if (known(s.leak))
    row("leak while shut",
        fmt::format("{:.3g} l/h{}", litres_per_hour * s.leak,
                    known(s.leak_class)
                        ? fmt::format(", within class {} of FCI 70-2",
                                      classes[static_cast<std::size_t>(s.leak_class) - 1])
                        : ""));
  row("least pressure within the seat", fmt::format("{:.4g} kPa", s.pressure_least / 1e3));
  if (known(s.cell_least))
    row("least pressure in a cell", fmt::format("{:.4g} kPa", s.cell_least / 1e3));
  if (known(s.cavitation))
    row("cavitation number, last tenth", fmt::format("{:.3g}", s.cavitation));
  return t;
}

}  // namespace velum::cases
