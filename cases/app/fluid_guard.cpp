#include "cases/app/fluid_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.hpp"

namespace velum::cases {

std::string fault(lbm::Observation const& seen)
{
  double const mach = seen.speed_max * std::numbers::sqrt3;
  double const density = std::max(std::abs(seen.rho_min), std::abs(seen.rho_max));
  if (seen.not_finite > 0)
    return fmt::format("the fluid is no longer finite in {} cells", seen.not_finite);
  if (!(mach < 1)) return fmt::format("the fluid moves at Mach {:.2f}", mach);
  if (!(density < 0.5)) return fmt::format("the density is off by {:.0f} %", 100 * density);
  if (seen.clipped) return "16-bit storage has reached the end of its range";
  return {};
}

void diverge(Derived const& d, std::string const& what, lbm::CellPlace const& worst, long step)
{
  std::string const cause =
      d.mach > 0.3
          ? fmt::format("lattice.mach is too large (the flow was to reach {:.2g})", d.mach)
          : fmt::format("tau - 1/2 = {:.2g} is too small for this collision", d.tau_minus_half);
  Vec3 const at = 1e3 * core::position(d.grid, worst.i, worst.j, worst.k);
  bool const space = core::dimensions(d.grid.symmetry) == 3;
  throw core::Divergence(fmt::format(
      "Diverged at step {} (t = {:.4g} s): {}, worst in cell ({}, {}{}) at ({:.4g}, {:.4g}{}) mm. "
      "Likely cause: {}.",
      step, core::to_si_time(d.units, double(step)), what, worst.i, worst.j,
      space ? fmt::format(", {}", worst.k) : "", at[0], at[1],
      space ? fmt::format(", {:.4g}", at[2]) : "", cause));
}

}  // namespace velum::cases
