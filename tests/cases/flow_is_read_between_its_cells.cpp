// problem:   a parabola in all coordinates on a lattice with a disc or a sphere in it, read between
//            the cells, on the body and beside the sides of the box
// reference: the parabola itself
// measure:   largest deviation over places in the fluid and on the surface of the disc
// tolerance: 1e-10
// why:       both rules of state_at() are exact for parabolas; what is left is round-off
#include <gtest/gtest.h>

#include <cmath>

#include "cases/app/sample.hpp"
#include "lbm/lattice/d3q19.hpp"

namespace velum {
namespace {

double parabola(core::Vec3 const& p)
{
  return 0.3 + 0.1 * p[0] - 0.2 * p[1] + 0.05 * p[0] * p[0] - 0.04 * p[0] * p[1] +
         0.03 * p[1] * p[1] + 0.07 * p[2] - 0.02 * p[2] * p[2] + 0.06 * p[0] * p[2];
}

template <class L>
void check_parabola(core::Symmetry symmetry, int n)
{
  double const dx = 0.25, radius = 0.8;
  core::Vec3 const centre = {2.1, 1.9, L::D == 3 ? 2.0 : 0.0};
  auto const fluid = lbm::make_fluid<double, L>(n, n, {}, symmetry, {}, n);
  auto const walls =
      lbm::find_walls(fluid, core::SignedDistance<L::D>([&](core::Vec<double, L::D> const& p) {
                        core::Vec<double, L::D> away;
                        for (int a = 0; a < L::D; ++a) away[a] = p[a] - centre[a] / dx;
                        return core::norm(away) - radius / dx;
                      }));
  core::Grid const grid{n, n, dx, {}, symmetry, fluid.nz};
  lbm::CellStates cells("cells", fluid.nz * n, n);
  for (int row = 0; row < fluid.nz * n; ++row)
    for (int i = 0; i < n; ++i) {
      int const j = row % n, k = row / n;
      double const v = walls.is_solid(i, j, k) ? 1e6 : parabola(core::position(grid, i, j, k));
      cells(row, i) = {v, 2 * v, -v, 3 * v};
    }
  cases::Sampled const flow{grid, walls, cells, {}};
  for (double angle = 0; angle < 6.28; angle += L::D == 3 ? 0.5 : 0.1)
    for (double r : {radius, 1.1 * radius, 1.5, 1.8}) {
      double const up = L::D == 3 ? 0.5 : 0;
      core::Vec3 const p = centre + r * core::Vec3{std::cos(angle) * std::cos(up),
                                                   std::sin(angle) * std::cos(up), std::sin(up)};
      auto const state = cases::state_at(flow, p);
      EXPECT_NEAR(state.rho, parabola(p), 1e-10) << p[0] << " " << p[1] << " " << p[2];
      EXPECT_NEAR(state.ux, 2 * parabola(p), 1e-10);
      EXPECT_NEAR(state.uz, 3 * parabola(p), 1e-10);
    }
}

TEST(Sample, ReproducesAParabolaAlsoOnAWall)
{
  check_parabola<lbm::D2Q9>(core::Symmetry::planar, 16);
}

TEST(Sample, ReproducesAParabolaInSpace) { check_parabola<lbm::D3Q19>(core::Symmetry::none, 16); }

TEST(Sample, SeesThroughPeriodicSides)
{
  int const n = 8;
  auto const fluid = lbm::make_fluid<double>(n, n, {0, 0}, core::Symmetry::planar, {});
  auto const walls = lbm::find_walls(fluid, {});
  core::Grid const grid{n, n, 1, {0, 0}, core::Symmetry::planar};
  lbm::CellStates cells("cells", n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) cells(j, i) = {std::cos(2 * std::acos(-1.0) * (i + 0.5) / n), 0, 0};
  cases::Sampled const flow{grid, walls, cells, {true, true, false}};
  EXPECT_NEAR(cases::state_at(flow, {0, 3}).rho, cases::state_at(flow, {n, 3}).rho, 1e-14);
  EXPECT_NEAR(cases::state_at(flow, {0, 3}).rho, 1, 0.02);
}

}  // namespace
}  // namespace velum
