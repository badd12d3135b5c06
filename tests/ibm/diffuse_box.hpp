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
      open.push_back({h.i, h.j, std::int16_t(h.dir), 0, 1.0f, h.q});
    else
      rest.push_back(h);
  }
  if (spec.open) {
    lbm::Opening o;
    o.kind = lbm::OpeningKind::pressure;
    o.normal = {-1, 0};
    lbm::upload(o.links, open);
    o.area = lbm::opening_area(s.fluid, open, o.normal);
    s.openings.push_back(o);
    s.targets.push_back(0);
  }
  double const all_downstream = 2.0 * spec.ny;
  s.body = ibm::make_diffuse(s.fluid, sharp.body.walls, rest, s.membrane, all_downstream);
  s.stepper = structure::explicit_stepper(s.membrane, spec.damping);
  return s;
}

/// All nodes driven along x at the given speed (any function of the reference radius).
inline void drive(DiffuseScene& s, std::function<double(double)> const& speed)
{
  for (int a = 0; a < structure::node_count(s.membrane); ++a) {
    s.membrane.fixed[static_cast<std::size_t>(2 * a)] = 1;
    s.membrane.fixed[static_cast<std::size_t>(2 * a + 1)] = 1;
    s.membrane.velocity[2 * a] = speed(s.membrane.reference[2 * a + 1]);
    s.membrane.velocity[2 * a + 1] = 0;
  }
}

}  // namespace velum::tests
