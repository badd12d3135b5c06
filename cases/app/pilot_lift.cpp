#include "cases/app/pilot_lift.hpp"

#include <algorithm>

#include "cases/app/derived.hpp"
#include "structure/static_solve.hpp"

namespace velum::cases {
namespace {

constexpr int elements = 54;  // over the radius
constexpr int places = 8;     // of the movement

/// Axial place of the disc's line at a radius.
double axial_at(structure::Membrane const& m, double radius)
{
  int a = 0;
  while (a + 2 < node_count(m) && m.position[2 * a + 3] < radius) ++a;
  auto const p = structure::node(m.position, a), q = structure::node(m.position, a + 1);
  return p[0] + (radius - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
}

}  // namespace

Curve pilot_lift(PilotMembrane const& pilot, Material const& material, double ring_radius,
                 double largest)
{
  MembraneSheet const sheet{.shape = MembraneShape::disc,
                            .material = pilot.material,
                            .position = 0,
                            .from = 0,
                            .to = pilot.radius,
                            .thickness = pilot.thickness,
                            .element = pilot.radius / elements};
  auto m = make_membrane(sheet, material, core::Symmetry::axisymmetric);
  auto const loads = bending_of(sheet, m);
  auto const driven = structure::nodes_within(m, pilot.boss);
  for (int a : driven) m.fixed[2 * a] = m.fixed[2 * a + 1] = 1;
  Curve lift{{0}, {0}};
  for (int k = 1; k <= places; ++k) {
    double const moved = largest * k / places;
    for (int a : driven) m.position[2 * a] = moved;
    structure::static_solve(m, loads);
    lift.at.push_back(moved);
    lift.value.push_back(std::max(0.0, axial_at(m, ring_radius)));
  }
  return lift;
}

}  // namespace velum::cases
