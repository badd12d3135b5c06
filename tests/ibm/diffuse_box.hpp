#pragma once
#include "ibm/diffuse.hpp"
#include "tests/support/piston.hpp"

namespace velum::tests {

using DiffuseScene = ibm::Coupled<double, ibm::Diffuse>;

/// The piston's box with a diffuse membrane; both sides across x are pressure openings when open,
/// for a diffuse membrane does not hold the suction of a closed chamber behind it.
inline DiffuseScene make_diffuse_box(PistonSpec const& spec)
{
  SharpScene sharp = make_piston(spec);
  DiffuseScene s;
  s.fluid = sharp.fluid;
  s.walls = sharp.walls;
  s.membrane = sharp.membrane;
  s.openings = sharp.openings;
  s.targets = sharp.targets;
  std::vector<lbm::WallHit> rest;
  std::vector<lbm::Link> open;
  for (lbm::WallHit const& h : sharp.body.wall_hits) {
    if (spec.open && lbm::D2Q9::cx(h.dir) == 1 && h.i == spec.nx - 1)
      open.push_back({h.i, h.j, std::int16_t(h.dir), lbm::Stencil::half_way, 1.0f, h.q});
    else
      rest.push_back(h);
  }
  open_side(s, open, {-1, 0});
  double const all_downstream = 2.0 * spec.ny;
  s.body = ibm::make_diffuse(s.fluid, sharp.body.walls, rest, s.membrane, all_downstream);
  s.stepper = structure::explicit_stepper(s.membrane, spec.damping);
  return s;
}

}  // namespace velum::tests
