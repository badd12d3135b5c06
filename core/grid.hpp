#pragma once
#include "core/symmetry.hpp"
#include "core/vec.hpp"

namespace velum::core {

/// nx times ny times nz cubic cells of side dx, in a plane nx times ny squares; origin is the outer
/// corner of cell (0, 0, 0). i counts along the axis, j across it; an array over the cells is
/// stored with i fastest.
struct Grid {
  int nx, ny;
  double dx;
  Vec3 origin;
  Symmetry symmetry;
  int nz = 1;
};

/// Centre of cell (i, j, k): origin + (i + 1/2, j + 1/2, k + 1/2) dx.
inline Vec3 position(Grid const& grid, int i, int j, int k = 0)
{
  Vec3 p = grid.origin;
  int const cell[] = {i, j, k};
  for (int a = 0; a < dimensions(grid.symmetry); ++a) p[a] += (cell[a] + 0.5) * grid.dx;
  return p;
}

/// Coordinates of p in cells, whole numbers at the centres: the inverse of position(). In a plane
/// the last is 0.
inline Vec3 cell_coordinates(Grid const& grid, Vec3 const& p)
{
  Vec3 c;
  for (int a = 0; a < dimensions(grid.symmetry); ++a)
    c[a] = (p[a] - grid.origin[a]) / grid.dx - 0.5;
  return c;
}

}  // namespace velum::core
