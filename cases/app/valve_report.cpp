#include "cases/app/valve_report.hpp"

#include <fmt/format.h>

#include "cases/app/chatter.hpp"
#include "cases/app/valve_figures.hpp"
#include "cases/app/valve_ramp.hpp"

namespace velum::cases {
namespace {

/// Pressure of a boundary over time; where its flow is given, what the history has beside it.
Curve pressure_over_time(Scene const& scene, char const* name, History const& history,
                         char const* column)
{
  Boundary const* const b = find_boundary(scene, name);
  return b && imposes_pressure(b->kind) ? b->value : Curve{history.time, history.column(column)};
}

std::string stretch_text(StretchRecord const& stretch)
{
  std::string const face =
      stretch.face > 0 ? fmt::format(", {:.4f} in a face that bends", stretch.face) : "";
  return fmt::format("  {:<34} {:.4f}{}\n", "largest stretch of the membrane", stretch.largest,
                     face);
}

}  // namespace

ValveReport valve_report(Scene const& scene, History const& history, ValveSeen const& seen)
{
  ValveFacts const facts{.density = scene.fluid.density,
                         .seals_at = scene.gap.seals_at,
                         .inlet = pressure_over_time(scene, "inlet", history, "pressure_outside"),
                         .outlet = pressure_over_time(scene, "outlet", history, "pressure_inside"),
                         .seat_diameter = seen.seat_diameter};
  ChatterSignals signals{history.time, history.column("gap"), history.column("pressure_outside"),
                         history.column("flow")};
  auto const inside = history.column("pressure_inside");
  for (std::size_t k = 0; k < inside.size(); ++k) signals.pressure[k] -= inside[k];

  ChatterRule const rule;
  auto const sheet = valve_sheet(history, facts);
  auto const chatter = find_chatter(signals, rule);
  // a pressure that is measured, not imposed, wobbles up and down of itself
  Boundary const* const inlet = find_boundary(scene, "inlet");
  bool const imposed = inlet && imposes_pressure(inlet->kind);
  auto const ramp = imposed ? valve_ramp(history, facts) : ValveRamp{};
  auto const kv = kv_over_lift(history, facts);
  ValveReport report{figures(sheet),
                     {},
                     valve_text(sheet) + ramp_text(ramp) + stretch_text(seen.stretch) +
                         chatter_text(chatter, rule),
                     kv.empty() ? "" : csv(kv)};
  for (auto& figure : figures(ramp)) report.figures.push_back(std::move(figure));
  for (auto& figure : figures(chatter)) report.figures.push_back(std::move(figure));
  report.rules["valve figures"] = fmt::format(
      "final values are means of the last tenth of the time; Kv and cavitation number by the "
      "pressures of inlet and outlet, vapour at {:.4g} kPa and atmosphere at {:.4g} kPa; leak "
      "class by the limits of FCI 70-2, V only where the seat's diameter is known; the valve "
      "cracks and reseats where its gap passes the width at which it seals while the pressure "
      "difference rises and falls, at the speed at which the scene changes it",
      facts.vapour_pressure / 1e3, facts.atmosphere / 1e3);
  report.rules["chatter"] = fmt::format(
      "an oscillation of the gap about its mean over two periods by more than {:.3g} um, for {:g} "
      "cycles or more, {:.0f} % of its power near one frequency and its harmonics; a limit cycle "
      "changes by less than {:.0f} % over its later half",
      1e6 * rule.threshold, rule.fewest_cycles, 100 * rule.share, 100 * rule.steady_change);
  return report;
}

}  // namespace velum::cases
