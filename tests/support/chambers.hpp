#pragma once
#include <algorithm>
#include <cmath>

#include "tests/support/piston.hpp"

namespace velum::tests {

/// What a chamber on one side of a membrane holds: its volume by the polyline of its face, and mass
/// and mean density (less 1) by its cells.
struct Chamber {
  double volume = 0, mass = 0, density = 0;
  double lowest = 1e30, highest = -1e30;  // density less 1 of its cells
};

/// The two chambers of a box without solids that a membrane divides: [0] plus side, [1] minus side.
struct Chambers {
  Chamber side[2];
};

/// Volume between x = 0 and a face within 0 <= y <= height, signed parts summed: the face may run
/// on into the walls.
inline double volume_below(ibm::FaceLine const& face, double height, core::Symmetry symmetry)
{
  double volume = 0;
  for (std::size_t a = 0; a + 1 < face.points.size(); ++a) {
    auto const [x0, y0] = face.points[a].c;
    auto const [x1, y1] = face.points[a + 1].c;
    double const ya = std::clamp(y0, 0.0, height), yb = std::clamp(y1, 0.0, height);
    if (ya == yb) continue;
    double const slope = (x1 - x0) / (y1 - y0);
    double const xa = x0 + slope * (ya - y0), xb = x0 + slope * (yb - y0);
    double const ra = core::ring(symmetry, ya), rb = core::ring(symmetry, yb);
    volume += (yb - ya) * (xa * (2 * ra + rb) + xb * (ra + 2 * rb)) / 6;
  }
  return volume;
}

template <class Real>
Chambers chambers(SharpSceneOf<Real> const& s)
{
  auto const& fluid = s.fluid;
  auto const symmetry = fluid.symmetry;
  bool const round = symmetry == core::Symmetry::axisymmetric;
  Chambers c;
  double const section = round ? std::acos(-1.0) * fluid.ny * fluid.ny : fluid.ny;
  c.side[0].volume = section * fluid.nx - volume_below(s.body.surface.plus, fluid.ny, symmetry);
  c.side[1].volume = volume_below(s.body.surface.minus, fluid.ny, symmetry);
  double area[2] = {0, 0};
  auto const state = lbm::cell_states(fluid);
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i) {
      auto const at = s.body.cells.at(i, j);
      if (!ibm::is_fluid(at)) continue;
      int const k = at == ibm::fluid_plus ? 0 : 1;
      double const ring = core::ring(symmetry, fluid.origin[1] + j + 0.5), rho = state(j, i).rho;
      area[k] += ring;
      c.side[k].mass += ring * rho;
      c.side[k].lowest = std::min(c.side[k].lowest, rho);
      c.side[k].highest = std::max(c.side[k].highest, rho);
    }
  for (int k : {0, 1}) c.side[k].density = c.side[k].mass / area[k];
  return c;
}

}  // namespace velum::tests
