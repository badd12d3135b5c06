#include "core/grid.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

using namespace core;

TEST(Grid, positions_and_cells_are_inverse)
{
  Grid const grid{7, 4, 0.25, {-1, 0}, Symmetry::axisymmetric};
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      Vec3 const p = position(grid, i, j), c = cell_coordinates(grid, p);
      EXPECT_DOUBLE_EQ(p[0], -1 + 0.25 * (i + 0.5));
      EXPECT_DOUBLE_EQ(p[1], 0.25 * (j + 0.5));
      EXPECT_EQ(p[2], 0) << "a plane stays in its plane";
      EXPECT_NEAR(c[0], i, 1e-14);
      EXPECT_NEAR(c[1], j, 1e-14);
      EXPECT_EQ(c[2], 0);
    }
}

TEST(Grid, positions_and_cells_are_inverse_in_space)
{
  Grid const grid{7, 4, 0.25, {-1, 0, 2}, Symmetry::none, 3};
  for (int k = 0; k < grid.nz; ++k) {
    Vec3 const p = position(grid, 1, 2, k), c = cell_coordinates(grid, p);
    EXPECT_DOUBLE_EQ(p[2], 2 + 0.25 * (k + 0.5));
    EXPECT_NEAR(c[2], k, 1e-14);
  }
}

}  // namespace
}  // namespace velum::tests
