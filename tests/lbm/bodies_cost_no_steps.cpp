// problem:   a box with half of it solid: the upper half along x, y or z; a cylinder's bore along x
//            or z; a periodic array of balls; widths that are no multiple of a vector
// reference: the cells with fluid, and the runs that they make along x
// measure:   the spans of cells that a step updates
// tolerance: none: every cell with fluid in one span and in no other; no more cells than the runs
//            rounded up to whole vectors
// why:       what a step costs is the cells it updates; a body is worth leaving out only if its
//            cells are
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lbm/walls.hpp"
#include "tests/support/lattices.hpp"

namespace velum {
namespace {

using Solid = core::SignedDistance<3>;

struct Cover {
  long fluid = 0;       // cells with fluid
  long rounded = 0;     // these, each run along x rounded up to vectors
  long updated = 0;     // cells of all spans
  long fluid_once = 0;  // cells with fluid in exactly one span
  long twice = 0;       // cells in more than one span
};

void count_spans(lbm::Fluid<float, lbm::D3Q19> const& fluid, Cover& cover)
{
  auto const spans = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.spans);
  auto const active = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.active);
  std::vector<int> times(active.extent(0));
  for (std::size_t s = 0; s < spans.extent(0); ++s)
    for (int c = 0; c < spans(s).length; ++c) ++times[std::size_t(spans(s).cell + c)];
  for (std::size_t cell = 0; cell < times.size(); ++cell) {
    cover.updated += times[cell];
    if (times[cell] > 1) ++cover.twice;
    if (times[cell] == 1 && active(cell) != 0) ++cover.fluid_once;
  }
}

void count_runs(lbm::Walls const& walls, Cover& cover)
{
  int const vector = lbm::vector_cells;
  for (int k = 0; k < walls.nz; ++k)
    for (int j = 0; j < walls.ny; ++j)
      for (int i = 0, run = 0; i <= walls.nx; ++i) {
        if (i < walls.nx && !walls.is_solid(i, j, k)) {
          ++run;
          continue;
        }
        cover.fluid += run;
        cover.rounded += (run + vector - 1) / vector * vector;
        run = 0;
      }
}

Cover cover(int n, Solid const& solid)
{
  auto fluid = lbm::make_fluid<float, lbm::D3Q19>(n, n, {}, core::Symmetry::planar, {}, n);
  auto const walls = lbm::find_walls(fluid, solid);
  lbm::deactivate_solids(fluid, walls);
  Cover c;
  count_spans(fluid, c);
  count_runs(walls, c);
  return c;
}

void expect_fluid_only(int n, Solid const& solid)
{
  auto const c = cover(n, solid);
  EXPECT_EQ(c.fluid_once, c.fluid);
  EXPECT_EQ(c.twice, 0);
  EXPECT_LE(c.updated, c.rounded);
  EXPECT_GT(c.fluid, 0.4 * n * n * n);
  EXPECT_LT(c.fluid, 0.6 * n * n * n);
}

TEST(Spans, OfAHalfFilledBoxCoverTheFluidAlone)
{
  for (int n : {48, 64, 77})
    for (int axis = 0; axis < 3; ++axis) {
      SCOPED_TRACE(testing::Message() << n << " cells, upper half of axis " << axis << " solid");
      expect_fluid_only(n, [&](core::Vec3 const& p) { return n / 2 - p[axis]; });
    }
}

TEST(Spans, OfABoreCoverTheFluidAlone)
{
  for (int n : {48, 64, 77})
    for (int axis : {0, 2}) {
      SCOPED_TRACE(testing::Message() << n << " cells, bore along axis " << axis);
      expect_fluid_only(n, [&](core::Vec3 p) {
        for (int a = 0; a < 3; ++a) p[a] = a == axis ? 0 : p[a] - n / 2.0;
        return 0.4 * n - norm(p);
      });
    }
}

TEST(Spans, BetweenBallsCoverTheFluidAlone)
{
  for (int n : {64, 96}) {
    SCOPED_TRACE(testing::Message() << n << " cells");
    double const cell = n / 2.0;
    expect_fluid_only(n, [&](core::Vec3 p) {
      for (int a = 0; a < 3; ++a) p[a] = std::fmod(p[a], cell) - cell / 2;
      return norm(p) - 0.49 * cell;
    });
  }
}

}  // namespace
}  // namespace velum
