#include "cases/app/open_area.hpp"

#include <algorithm>
#include <cmath>

#include "cases/app/geometry.hpp"

namespace velum::cases {

namespace {

/// Middles of equal parts of a range within the box.
struct Samples {
  double from = 0, step = 1;
  int count = 1;

  double at(int n) const { return from + (n + 0.5) * step; }
};

Samples samples(double from, double to, double dx, int per_cell)
{
  if (to <= from) return {from, 0, 0};
  int const count = std::max(1, static_cast<int>(std::ceil((to - from) / dx * per_cell - 1e-6)));
  return {from, (to - from) / count, count};
}

}  // namespace

double open_area(Scene const& scene, Derived const& d, Patch const& patch)
{
  core::Grid const& grid = d.grid;
  BoxSide const side = *box_side(patch.side);
  int const lines = dimensions(scene) - 1, per_cell = lines == 1 ? 256 : 8;
  int const cells[] = {grid.nx, grid.ny, grid.nz};
  double const origin[] = {grid.origin[0], grid.origin[1], grid.origin[2]};
  Samples along[2];
  for (int k = 0; k < lines; ++k) {
    int const axis = axis_along(side, k);
    along[k] =
        samples(std::max(patch.from[k], origin[axis]),
                std::min(patch.to[k], origin[axis] + cells[axis] * grid.dx), grid.dx, per_cell);
  }
  auto const walls = distance_to_solids(scene);
  Vec3 p;
  p[side.axis] = origin[side.axis] + (side.upper ? cells[side.axis] - 0.5 : 0.5) * grid.dx;
  double const edge = origin[1] + (side.upper ? cells[1] * grid.dx : 0);
  double area = 0;
  for (int m = 0; m < along[0].count; ++m)
    for (int n = 0; n < along[1].count; ++n) {
      Vec2 const at = {along[0].at(m), lines == 2 ? along[1].at(n) : 0};
      for (int k = 0; k < lines; ++k) p[axis_along(side, k)] = at[k];
      if (!covers(patch, at, dimensions(scene)) || walls(p) <= 0) continue;
      double const radius = side.axis == 1 ? edge : p[1];
      area += core::ring(grid.symmetry, radius / grid.dx);
    }
  return area * along[0].step * (lines == 2 ? along[1].step / grid.dx : 1) / grid.dx;
}

}  // namespace velum::cases
