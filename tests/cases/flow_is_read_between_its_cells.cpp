// problem:   a parabola in both coordinates on a lattice with a disc in it, read between the cells,
//            on the disc and beside the sides of the box
// reference: the parabola itself
// measure:   largest deviation over places in the fluid and on the surface of the disc
// tolerance: 1e-10
// why:       both rules of state_at() are exact for parabolas; what is left is round-off
#include <gtest/gtest.h>

#include <cmath>

#include "cases/app/sample.hpp"

namespace velum {
namespace {

double parabola(core::Vec2 const& p)
{
  return 0.3 + 0.1 * p[0] - 0.2 * p[1] + 0.05 * p[0] * p[0] - 0.04 * p[0] * p[1] +
         0.03 * p[1] * p[1];
}

TEST(Sample, ReproducesAParabolaAlsoOnAWall)
{
  int const n = 16;
  double const dx = 0.25;
  core::Vec2 const centre = {2.1, 1.9};
  double const radius = 0.8;
  auto const fluid = lbm::make_fluid<double>(n, n, {0, 0}, core::Symmetry::planar, {});
  auto const walls = lbm::find_walls(fluid, core::disc((1 / dx) * centre, radius / dx));
  core::Grid const grid{n, n, dx, {0, 0}, core::Symmetry::planar};
  lbm::CellStates cells("cells", n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      double const v = walls.is_solid(i, j) ? 1e6 : parabola(core::position(grid, i, j));
      cells(j, i) = {v, 2 * v, -v};
    }
  cases::Sampled const flow{grid, walls, cells, false, false};
  for (double angle = 0; angle < 6.28; angle += 0.1)
    for (double r : {radius, 1.1 * radius, 1.5, 1.8}) {
      core::Vec2 const p = centre + r * core::Vec2{std::cos(angle), std::sin(angle)};
      auto const state = cases::state_at(flow, p);
      EXPECT_NEAR(state.rho, parabola(p), 1e-10) << p[0] << " " << p[1];
      EXPECT_NEAR(state.ux, 2 * parabola(p), 1e-10);
    }
}

TEST(Sample, SeesThroughPeriodicSides)
{
  int const n = 8;
  auto const fluid = lbm::make_fluid<double>(n, n, {0, 0}, core::Symmetry::planar, {});
  auto const walls = lbm::find_walls(fluid, {});
  core::Grid const grid{n, n, 1, {0, 0}, core::Symmetry::planar};
  lbm::CellStates cells("cells", n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) cells(j, i) = {std::cos(2 * std::acos(-1.0) * (i + 0.5) / n), 0, 0};
  cases::Sampled const flow{grid, walls, cells, true, true};
  EXPECT_NEAR(cases::state_at(flow, {0, 3}).rho, cases::state_at(flow, {n, 3}).rho, 1e-14);
  EXPECT_NEAR(cases::state_at(flow, {0, 3}).rho, 1, 0.02);
}

}  // namespace
}  // namespace velum
