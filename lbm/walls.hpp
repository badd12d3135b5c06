#pragma once
#include <vector>

#include "core/obstacle.hpp"
#include "lbm/link.hpp"

namespace velum::lbm {

/// Where a link of a fluid cell meets a rigid wall.
struct WallHit {
  int i, j, dir;
  double q;       // true distance to the wall as a share of the link
  core::Vec2 at;  // the point, lattice units
  bool box_side;  // the wall is the side of the lattice box, not a solid
};

/// The rigid surroundings of the fluid, found once.
struct Walls {
  int nx = 0, ny = 0;
  std::vector<std::uint8_t> solid;  // [ny][nx], 1 where the cell centre is in a solid
  std::vector<double> distance;     // [ny][nx], signed distance to the solids, cells
  std::vector<WallHit> hits;

  bool is_solid(int i, int j) const { return solid[static_cast<std::size_t>(j * nx + i)] != 0; }
};

/// Classifies the cells of the lattice box and finds the wall's distance on every link that leaves
/// the fluid, by bisection of the signed distance along the link. The sides of the box are walls
/// half-way between cells unless periodic or the axis.
/// @param solids  signed distance in lattice units, positive in the fluid
template <class Real>
Walls find_walls(Fluid<Real> const& fluid, core::Obstacle const& solids);

/// Marks solid cells inactive.
template <class Real>
void deactivate_solids(Fluid<Real>& fluid, Walls const& walls);

/// The neighbour that a link leads to, seen through the axis and periodic sides;
/// i = -1 where it is outside the box.
struct Neighbour {
  int i, j;
};
template <class Real>
Neighbour neighbour(Fluid<Real> const& fluid, int i, int j, int dir);

/// The link of a wall hit; its second cell is the one behind, where that is fluid.
template <class Real>
Link link_at(Fluid<Real> const& fluid, Walls const& walls, WallHit const& hit, double weight = 1);

}  // namespace velum::lbm
