#include "core/grid.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

using namespace core;

TEST(Grid, positions_and_cells_are_inverse)
{
  Grid const grid{7, 4, 0.25, {-1, 0}, Symmetry::axisymmetric};
  EXPECT_EQ(size(grid), 28);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      Vec2 const p = position(grid, i, j), c = cell_coordinates(grid, p);
      EXPECT_DOUBLE_EQ(p[0], -1 + 0.25 * (i + 0.5));
      EXPECT_DOUBLE_EQ(p[1], 0.25 * (j + 0.5));
      EXPECT_NEAR(c[0], i, 1e-14);
      EXPECT_NEAR(c[1], j, 1e-14);
      EXPECT_EQ(index(grid, i, j), i + 7 * j);
    }
}

TEST(Grid, contains_its_cells_and_their_edges)
{
  Grid const grid{7, 4, 0.25, {-1, 0}, Symmetry::planar};
  EXPECT_TRUE(contains(grid, {-1, 0}));
  EXPECT_TRUE(contains(grid, {0.75, 1}));
  EXPECT_FALSE(contains(grid, {-1.01, 0.5}));
  EXPECT_FALSE(contains(grid, {0, 1.01}));
}

}  // namespace
}  // namespace velum::tests
