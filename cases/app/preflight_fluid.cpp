#include "cases/app/preflight.hpp"

#include "cases/app/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace velum::cases {
namespace {

/// Width of the widest patch, doubled where it starts on the axis; of the domain without patches.
double passage(Scene const& scene)
{
  double width = 0;
  for (auto const& boundary : scene.boundaries)
    for (auto const& patch : boundary.patches) {
      bool const on_axis = symmetry(scene) == core::Symmetry::axisymmetric && patch.from[0] == 0 &&
                           box_side(patch.side).value_or(BoxSide{0, false}).axis == 0;
      double across = patch.to[0] - patch.from[0];
      if (dimensions(scene) == 3) across = std::min(across, patch.to[1] - patch.from[1]);
      width = std::max(width, (on_axis ? 2 : 1) * across);
    }
  return width > 0 ? width : scene.lattice.to[1] - scene.lattice.from[1];
}

Row mach_row(Scene const& scene, Derived const& d)
{
  // Compressibility errors grow with Mach^2; the collision operators lose stability near 0.5.
  Row row{"Mach number", d.mach, "", Verdict::ok, ""};
  std::string const mend =
      scene.lattice.time_step
          ? fmt::format("lattice.time_step <= \"{:.3g} us\"", 1e6 * d.units.dt * 0.2 / d.mach)
          : "lattice.mach <= 0.2";
  if (d.mach > 0.2)
    row.verdict = Verdict::warn, row.remark = "errors grow with its square: " + mend;
  if (d.mach > 0.5) row.verdict = Verdict::red, row.remark = "unstable: " + mend;
  return row;
}

Row relaxation_row(Scene const& scene, Derived const& d)
{
  // At rest central moments and TRT hold down to 1e-5 (tests/lbm/still_water_stays_still.cpp); a
  // start-up flow in a 4-cell slit loses BGK and TRT below 1e-3. BGK feeds waves at rest as well.
  Collision const collision = scene.lattice.collision;
  bool const central = collision == Collision::central_moments || collision == Collision::cumulant;
  double const least = central ? 1e-5 : 1e-3;
  Row row{"relaxation time less 1/2", d.tau_minus_half, "", Verdict::ok, ""};
  std::string const finer =
      fmt::format("lattice.dx <= \"{:.3g} um\"", 1e6 * scene.lattice.dx * d.tau_minus_half / least);
  std::string const other = "lattice.collision = \"central_moments\"";
  if (d.tau_minus_half < least) {
    bool const feeds_waves = collision == Collision::bgk;
    row.verdict = feeds_waves ? Verdict::red : Verdict::warn;
    row.remark = central       ? "little damping of waves is left: " + finer
                 : feeds_waves ? "unstable: " + other
                               : "holds slow water, may lose a fast flow: " + other;
  } else if (d.tau_minus_half > 1) {
    row.verdict = Verdict::warn;
    row.remark = "walls lose accuracy above 1: a smaller lattice.mach does not pay here";
  }
  return row;
}

Row cell_reynolds_row(Scene const& scene, Derived const& d)
{
  Row row{"cell Reynolds number", d.cell_reynolds, "", Verdict::ok, ""};
  if (d.cell_reynolds <= 30) return row;
  switch (scene.les.model) {
    case LesModel::auto_:
      row.remark = "eddies below a cell; les.model = \"auto\" decides";
      break;
    case LesModel::smagorinsky:
    case LesModel::vreman:
      row.remark = "eddies below a cell are modelled";
      break;
    case LesModel::off:
      row.verdict = Verdict::warn;
      row.remark = "fast flow would have eddies below a cell: les.model = \"auto\"";
      break;
  }
  return row;
}

Row density_row(Scene const& scene, Derived const& d)
{
  // At the Bernoulli velocity the jump is Mach^2 / 2.
  Row row{"density jump, compressibility", 100 * d.density_jump, "%", Verdict::ok, ""};
  if (d.density_jump <= 0.02) return row;
  double const mach = scene.lattice.mach * std::sqrt(0.02 / d.density_jump);
  row.verdict = d.density_jump > 0.06 ? Verdict::red : Verdict::warn;
  row.remark = scene.lattice.time_step
                   ? fmt::format("lattice.time_step <= \"{:.3g} us\"",
                                 1e6 * d.units.dt * std::sqrt(0.02 / d.density_jump))
                   : fmt::format("lattice.mach <= {:.2g}", mach);
  return row;
}

Row transit_row(Scene const& scene, Derived const& d)
{
  Row row{"acoustic transit of the domain", 1e6 * d.acoustic_transit, "us", Verdict::ok, ""};
  if (scene.run.settle < 5 * d.acoustic_transit && scene.run.settle > 0) {
    row.verdict = Verdict::warn;
    row.remark = fmt::format("waves need five of them to die: run.settle >= \"{:.3g} ms\"",
                             5e3 * d.acoustic_transit);
  }
  return row;
}

}  // namespace

std::vector<Row> fluid_rows(Scene const& scene, Derived const& d)
{
  return {
      {"reference velocity", d.velocity, "m/s", Verdict::info, ""},
      {"Reynolds number of the passage", d.velocity * passage(scene) / scene.fluid.viscosity, "",
       Verdict::info, "if the flow reached the reference velocity there"},
      mach_row(scene, d),
      {"time step", 1e6 * d.units.dt, "us", Verdict::info,
       scene.lattice.time_step ? "as given" : "from Mach number and reference velocity"},
      relaxation_row(scene, d),
      cell_reynolds_row(scene, d),
      density_row(scene, d),
      transit_row(scene, d),
  };
}

}  // namespace velum::cases
