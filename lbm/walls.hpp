#pragma once
#include <cmath>
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

/// Viscosity up to which a parabola is taken where only one cell is behind (lbm/link.hpp).
inline constexpr double narrow_parabola_up_to = 0.05;

/// The cell behind, one step against dir, and the direction that dir has there: its mirror image
/// beyond a plane of symmetry or the axis.
struct Behind {
  Neighbour cell;
  int dir;
};
template <class Real, class L, class Stored>
Behind behind(Fluid<Real, L, Stored> const& fluid, Neighbour const& cell, int dir);

/// Sets what the wall at the distance l.q along a link reflects from (lbm/link.hpp): the model's
/// rule, less where a cell behind is missing. A line beyond the middle of the link needs none of
/// them, short of it one, a parabola two, or one. A parabola that is not defined with the collision
/// is a line; so is one in a bore a single row of cells in radius, which would feed itself through
/// the axis. With nothing but the side of the box behind it the wall is half-way: its mirror image
/// may belong to an opening, and what a wall sends back of the velocity along it has to cancel.
/// @param same  whether a neighbour is fluid of the link's own side
template <class Real, class L, class Stored, class Same>
void set_stencil(Fluid<Real, L, Stored> const& fluid, Link& l, Same const& same)
{
  Model const& model = fluid.model;
  l.stencil = Stencil::half_way;
  if (model.wall_rule == WallRule::half_way || std::abs(l.q - 0.5) < 1e-9) return;
  Behind const one = behind(fluid, {l.i, l.j, l.k}, l.dir);
  if (one.cell.i < 0 || (l.q < 0.5 && !same(one.cell))) return;
  l.stencil = Stencil::line;
  bool const through_axis = fluid.has_axis() && l.j == 0 && L::c(l.dir, 1) > 0;
  if (through_axis || !same(one.cell) || model.wall_rule == WallRule::linear ||
      !is_defined(model.collision, model.wall_rule))
    return;
  Behind const two = behind(fluid, one.cell, one.dir);
  bool const wide = two.cell.i >= 0 && same(two.cell);
  if (!wide && model.viscosity > narrow_parabola_up_to) return;
  l.stencil = wide ? Stencil::parabola : Stencil::narrow_parabola;
  Neighbour const& far = wide ? two.cell : one.cell;
  l.far = fluid.cell(far.i, far.j, far.k);
  l.far_dir = wide ? two.dir : L::opposite(one.dir);
}

/// The link of a wall hit, by the model's wall rule.
template <class Real, class L, class Stored>
Link link_at(Fluid<Real, L, Stored> const& fluid, Walls const& walls, WallHit const& hit,
             double weight = 1);

}  // namespace velum::lbm
