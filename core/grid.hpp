#pragma once
#include "core/symmetry.hpp"
#include "core/vec.hpp"

namespace velum::core {

/// nx times ny square cells of side dx; origin is the outer corner of cell (0, 0).
/// i counts along the axis, j across it; an array over the cells is stored with i fastest.
struct Grid {
  int nx, ny;
  double dx;
  Vec2 origin;
  Symmetry symmetry;
};

/// Number of cells.
KOKKOS_INLINE_FUNCTION int size(Grid const& grid) { return grid.nx * grid.ny; }

/// Place of cell (i, j) in an array over the cells.
KOKKOS_INLINE_FUNCTION int index(Grid const& grid, int i, int j) { return j * grid.nx + i; }

/// Centre of cell (i, j): origin + (i + 1/2, j + 1/2) dx.
KOKKOS_INLINE_FUNCTION Vec2 position(Grid const& grid, int i, int j)
{
  return grid.origin + Vec2{(i + 0.5) * grid.dx, (j + 0.5) * grid.dx};
}

/// Coordinates of p in cells, whole numbers at the centres: the inverse of position().
KOKKOS_INLINE_FUNCTION Vec2 cell_coordinates(Grid const& grid, Vec2 const& p)
{
  return {(p[0] - grid.origin[0]) / grid.dx - 0.5, (p[1] - grid.origin[1]) / grid.dx - 0.5};
}

/// True when p lies in a cell of the grid or on its edge.
KOKKOS_INLINE_FUNCTION bool contains(Grid const& grid, Vec2 const& p)
{
  Vec2 const c = cell_coordinates(grid, p);
  return c[0] >= -0.5 && c[0] <= grid.nx - 0.5 && c[1] >= -0.5 && c[1] <= grid.ny - 0.5;
}

}  // namespace velum::core
