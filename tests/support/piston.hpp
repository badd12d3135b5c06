#pragma once
#include "ibm/step.hpp"
#include "tests/support/flow.hpp"

namespace velum::tests {

template <class Real>
using SharpSceneOf = ibm::Coupled<Real, ibm::Sharp>;
using SharpScene = SharpSceneOf<double>;

/// A membrane across a box of nx by ny cells, at x = place, its rim continued into the side walls;
/// side x- of the box is an opening when open, everything else is wall.
struct PistonSpec {
  int nx, ny;
  core::Symmetry symmetry = core::Symmetry::planar;
  double place, thickness;
  double shear_modulus = 1, density = 1;
  double element = 1;
  bool open = true;
  lbm::Model model{lbm::Collision::central_moments, 0.01, 1.0 / 8};
  structure::Rayleigh damping{};
  std::function<double(double)> initial_shape = {};  // added to x over y
  core::Obstacle solids = no_solids();
  double from = 0;  // y of the first node
  double to = 0;    // y of the last node; 0: the side of the box
};

/// Opens the links of a side of the box at rest pressure; no links, no opening.
template <class Scene>
void open_side(Scene& s, std::vector<lbm::Link> const& links, core::Vec3 normal)
{
  if (links.empty()) return;
  lbm::Opening o;
  o.kind = lbm::OpeningKind::pressure;
  o.normal = normal;
  lbm::upload(o.links, links);
  o.area = lbm::opening_area(s.fluid, links, o.normal);
  s.openings.push_back(o);
  s.targets.push_back(0);
}

template <class Real = double>
SharpSceneOf<Real> make_piston(PistonSpec const& spec)
{
  SharpSceneOf<Real> s;
  s.fluid = lbm::make_fluid<Real>(spec.nx, spec.ny, {0, 0}, spec.symmetry, spec.model);
  s.walls = spec.solids;
  auto const walls = lbm::find_walls(s.fluid, s.walls);
  double const rim = spec.to > 0 ? spec.to : spec.ny;
  s.membrane = structure::flat_membrane(
      {spec.symmetry, spec.from, rim, spec.element, [&](double) { return spec.thickness; },
       structure::neo_hookean_rubber(spec.shear_modulus), spec.density, spec.place});
  if (spec.initial_shape)
    for (int a = 0; a < structure::node_count(s.membrane); ++a)
      s.membrane.position[2 * a] += spec.initial_shape(s.membrane.position[2 * a + 1]);
  std::vector<lbm::WallHit> rest;
  std::vector<lbm::Link> open;
  for (lbm::WallHit const& h : walls.hits) {
    bool const left = lbm::D2Q9::cx(h.dir) == -1 && h.i == 0;
    if (left && spec.open)
      open.push_back({h.i, h.j, std::int16_t(h.dir), lbm::Stencil::half_way, 1.0f, h.q});
    else
      rest.push_back(h);
  }
  open_side(s, open, {1, 0});
  s.body = ibm::make_sharp(s.fluid, walls, rest, s.membrane, 0);
  s.stepper = structure::explicit_stepper(s.membrane, spec.damping);
  return s;
}

/// All nodes driven along x at the given speed (any function of the reference radius).
template <class Scene>
void drive(Scene& s, std::function<double(double)> const& speed)
{
  for (int a = 0; a < structure::node_count(s.membrane); ++a) {
    s.membrane.fixed[static_cast<std::size_t>(2 * a)] = 1;
    s.membrane.fixed[static_cast<std::size_t>(2 * a + 1)] = 1;
    s.membrane.velocity[2 * a] = speed(s.membrane.reference[2 * a + 1]);
    s.membrane.velocity[2 * a + 1] = 0;
  }
}

/// Speed over y of a membrane held at its rim whose middle goes at 1; level at the rim, as a clamp
/// holds it. The middle is the axis, or half the way between the walls at 0 and to.
inline std::function<double(double)> clamped_speed(core::Symmetry symmetry, double to)
{
  bool const round = symmetry == core::Symmetry::axisymmetric;
  return [=](double y) {
    double const z = round ? y / to : (2 * y - to) / to;
    return (1 - z * z) * (1 - z * z);
  };
}

}  // namespace velum::tests
