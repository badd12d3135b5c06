#pragma once
#include <type_traits>
#include <vector>

#include "core/obstacle.hpp"
#include "core/signed_distance.hpp"
#include "lbm/link.hpp"

namespace velum::lbm {

/// Where a link of a fluid cell meets a rigid wall.
struct WallHit {
  int i, j, dir;
  double q;       // true distance to the wall as a share of the link
  core::Vec3 at;  // the point, lattice units
  bool box_side;  // the wall is the side of the lattice box, not a solid
  int k = 0;
};

/// The rigid surroundings of the fluid, found once.
struct Walls {
  int nx = 0, ny = 0, nz = 1;
  std::vector<std::uint8_t> solid;  // [nz][ny][nx], 1 where the cell centre is in a solid
  std::vector<double> distance;     // [nz][ny][nx], signed distance to the solids, cells
  std::vector<WallHit> hits;

  std::size_t index(int i, int j, int k = 0) const
  {
    return (static_cast<std::size_t>(k) * ny + j) * nx + i;
  }
  bool is_solid(int i, int j, int k = 0) const { return solid[index(i, j, k)] != 0; }
};

/// Classifies the cells of the lattice box and finds the wall's distance on every link that leaves
/// the fluid, by bisection of the signed distance along the link. The sides of the box are walls
/// half-way between cells unless periodic, a plane of symmetry or the axis.
/// @param solids  lattice units
template <class Real, class L, class Stored>
Walls find_walls(Fluid<Real, L, Stored> const& fluid,
                 std::type_identity_t<core::SignedDistance<L::D>> const& solids);
template <class Real, class Stored>
Walls find_walls(Fluid<Real, D2Q9, Stored> const& fluid, core::Obstacle const& solids)
{
  return find_walls(fluid, [&](core::Vec2 const& p) { return core::distance(solids, p); });
}

/// Takes the solid cells out of the fluid.
template <class Real, class L, class Stored>
void deactivate_solids(Fluid<Real, L, Stored>& fluid, Walls const& walls);

/// The neighbour that a link leads to, seen through the axis, mirrors and periodic sides;
/// i = -1 where it is outside the box.
struct Neighbour {
  int i, j, k = 0;
};
template <class Real, class L, class Stored>
Neighbour neighbour(Fluid<Real, L, Stored> const& fluid, int i, int j, int dir, int k = 0);

/// The link of a wall hit, by the model's wall rule; its second cell is the one behind, where that
/// is fluid.
template <class Real, class L, class Stored>
Link link_at(Fluid<Real, L, Stored> const& fluid, Walls const& walls, WallHit const& hit,
             double weight = 1);

}  // namespace velum::lbm
