#include "cases/app/certificate.hpp"

#include <fmt/format.h>

#include <cmath>

namespace velum::cases {

namespace {

double upstream(Measurement const& m) { return std::min(m.pressure_above, m.pressure_outside); }
double jump(Measurement const& m) { return upstream(m) - m.pressure_inside; }

/// Of the settled state and, where there is one, of the shut one.
double spurious_velocity(Certificate const& c)
{
  return c.has_shut ? std::max(c.settled.speed_max, c.shut.speed_max) : c.settled.speed_max;
}

/// Mean rates over the window before the settled state, m3/s.
struct Leak {
  double total;  // outflow less what the membrane swept and the fluid stored
  double seat, membrane;
};

Leak leak(Certificate const& c)
{
  Measurement const &a = c.window_begin, &b = c.settled;
  double const T = b.time - a.time;
  double const balance = (b.outflow - a.outflow) + (b.mass_inside - a.mass_inside);
  return {balance / T, (b.through_seat - a.through_seat) / T,
          (b.through_membrane - a.through_membrane) / T};
}

/// Volume that the balance of the inside cannot account for, as a share of that volume.
double volume_residual(Certificate const& c)
{
  Leak const l = leak(c);
  double const T = c.settled.time - c.window_begin.time;
  return std::abs(l.total - l.seat - l.membrane) * T / c.settled.volume_inside;
}

}  // namespace

std::vector<core::Figure> figures(Certificate const& c)
{
  if (c.driven) {
    auto f = figures(*c.driven);
    f.insert(f.end(), {{"stretch_max", c.stretch_max, "1"},
                       {"speed_max", c.speed_max, "m/s"},
                       {"mach_max", c.mach_max, "1"},
                       {"wall_time", c.wall_time, "s"},
                       {"membrane_share", c.membrane_share, "1"},
                       {"mlups", c.mlups, "1e6/s"}});
    return f;
  }
  Leak const l = leak(c);
  double const p = c.inlet - c.outlet;
  std::vector<core::Figure> f = {
      {"pressure_inlet", c.inlet, "Pa"},
      {"pressure_upstream", upstream(c.settled), "Pa"},
      {"pressure_downstream", c.settled.pressure_inside, "Pa"},
      {"pressure_jump_held", jump(c.settled) / p, "1"},
      {"leak", l.seat + l.membrane, "m3/s"},
      {"leak_through_seat", l.seat, "m3/s"},
      {"leak_through_membrane", l.membrane, "m3/s"},
      {"leak_by_balance", l.total, "m3/s"},
      {"leak_of_open_flow", (l.seat + l.membrane) / open_flow, "1"},
      {"sealed", c.settled.sealed ? 1.0 : 0.0, "1"},
      {"penetration", c.penetration_max, "m"},
      {"seat_force", c.settled.seat_force, "N"},
      {"centre_deflection", c.centre_start - c.settled.centre, "m"},
      {"centre_deflection_hydrostatic", c.centre_start - c.centre_hydrostatic, "m"},
      {"stretch_max", c.stretch_max, "1"},
      {"volume_residual", volume_residual(c), "1"},
      {"spurious_velocity", spurious_velocity(c), "m/s"},
      {"speed_max", c.speed_max, "m/s"},
      {"mach_max", c.mach_max, "1"},
      {"eddy_viscosity_mean", c.eddy_mean, "m2/s"},
      {"eddy_viscosity_max", c.eddy_max, "m2/s"},
      {"wall_time", c.wall_time, "s"},
      {"membrane_share", c.membrane_share, "1"},
      {"mlups", c.mlups, "1e6/s"},
  };
  if (c.has_shut) {
    f.push_back({"pressure_jump_held_shut", c.least_jump_shut / p, "1"});
    f.push_back({"pressure_upstream_shut", upstream(c.shut), "Pa"});
    f.push_back({"sealed_shut", c.shut.sealed ? 1.0 : 0.0, "1"});
  }
  return f;
}

std::string certificate_text(Certificate const& c)
{
  if (c.driven) return record_text(*c.driven);
  Leak const l = leak(c);
  double const p = c.inlet - c.outlet;
  double const deflection = c.centre_start - c.settled.centre;
  double const hydrostatic = c.centre_start - c.centre_hydrostatic;
  double const litres_per_hour = 3.6e6;
  bool const holds = p != 0;  // else no pressure is held, and shares of it say nothing
  std::string t =
      holds ? fmt::format("Certificate of the closed valve at {:.4g} kPa\n", c.inlet / 1e3)
            : "Membrane in water, no pressure held\n";
  auto const row = [&](std::string const& name, std::string const& value) {
    t += fmt::format("  {:<34} {}\n", name, value);
  };
  auto const share = [](double part, double of) {
    return of != 0 ? fmt::format(" ({:+.2f} %)", 100 * (part / of - 1)) : "";
  };
  if (holds) {
    row("pressure upstream", fmt::format("{:.3f} % of p_in", 100 * upstream(c.settled) / c.inlet));
    row("pressure downstream",
        fmt::format("{:.3f} % of p_in", 100 * c.settled.pressure_inside / c.inlet));
    row("jump held, inlet feeding", fmt::format("{:.3f} %", 100 * jump(c.settled) / p));
    if (c.has_shut)
      row("jump held, inlet shut",
          fmt::format("{:.3f} % at its least, {:.0f} ms after shutting",
                      100 * c.least_jump_shut / p, 1e3 * (c.shut.time - c.settled.time)));
    row("path from inlet to outlet", c.settled.sealed ? "none: sealed" : "open");
    row("leak through the seat", fmt::format("{:.3g} l/h", litres_per_hour * l.seat));
    row("leak through the membrane", fmt::format("{:.3g} l/h", litres_per_hour * l.membrane));
    row("leak, share of 200 l/h", fmt::format("{:.2g}", (l.seat + l.membrane) / open_flow));
    row("leak by outflow and balance", fmt::format("{:.3g} l/h", litres_per_hour * l.total));
    row("penetration at the seat", fmt::format("{:.3g} um", 1e6 * c.penetration_max));
    row("seat force", fmt::format("{:.4g} N", c.settled.seat_force));
  }
  row("centre deflection", fmt::format("{:.4f} mm", 1e3 * deflection));
  row("centre deflection, hydrostatic",
      fmt::format("{:.4f} mm{}", 1e3 * hydrostatic, share(deflection, hydrostatic)));
  row("largest stretch of the membrane", fmt::format("{:.4f}", c.stretch_max));
  row("volume balance residual", fmt::format("{:.2g} of the chamber", volume_residual(c)));
  row(holds ? "largest spurious velocity" : "largest velocity at the end",
      fmt::format("{:.3g} mm/s", 1e3 * spurious_velocity(c)));
  row("largest Mach number", fmt::format("{:.3g}", c.mach_max));
  row("wall time", fmt::format("{:.1f} s, {:.0f} MLUPS, {:.1f} % of it the membrane's steps",
                               c.wall_time, c.mlups, 100 * c.membrane_share));
  return t;
}

}  // namespace velum::cases
