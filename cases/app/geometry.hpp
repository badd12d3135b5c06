#pragma once
#include "cases/app/scene.hpp"
#include "core/obstacle.hpp"

#include <string>

namespace velum::cases {

/// A solid, shifted to its place; lengths in metres. In space: a profile is revolved.
core::Obstacle placed(Solid const& solid);
core::SignedDistance<3> placed_in_space(Solid const& solid);

/// A solid of the scene, shifted to its place; lengths in metres.
core::Obstacle solid(Scene const& scene, std::string const& name);

/// All solids together: the union of those that add, without those that subtract.
core::Obstacle all_solids(Scene const& scene);

/// The same for scenes of any dimension; of a plane the third coordinate is not looked at.
core::SignedDistance<3> solid_distance(Scene const& scene, std::string const& name);
core::SignedDistance<3> distance_to_solids(Scene const& scene);

/// A distance in metres as one over the points of a lattice of D dimensions, all in cells.
template <int D>
core::SignedDistance<D> in_cells(core::SignedDistance<3> const& distance, double dx)
{
  return [distance, dx](core::Vec<double, D> const& p) {
    Vec3 at;
    for (int a = 0; a < D; ++a) at[a] = dx * p[a];
    return distance(at) / dx;
  };
}

/// A side of the lattice box: the axis that crosses it, and whether it lies at `to` or at `from`.
struct BoxSide {
  int axis;
  bool upper;
};

/// "x-", "x+" ... "z+" as a side of the box; nothing for the name of a solid.
std::optional<BoxSide> box_side(std::string const& side);

/// All names of sides: four or six.
std::vector<std::string> side_names(int dimensions);

/// The k-th of the axes along a side, in the order x, y, z.
inline int axis_along(BoxSide const& side, int k) { return k + (k >= side.axis ? 1 : 0); }

/// Whether a side of the box is a plane of symmetry.
bool is_mirror(Scene const& scene, BoxSide const& side);

/// Whether a place along a side, or along a solid its second coordinate, is in the patch.
bool covers(Patch const& patch, Vec2 const& along, int dimensions);

/// True when at least one point of the patch looks onto fluid: just inside the box, or just outside
/// the named solid.
bool opens_to_fluid(Scene const& scene, Patch const& patch);

/// Shortest distance between the faces of the undeformed membrane and the seat; negative when they
/// overlap.
/// @pre the scene has a membrane and a contact
double initial_gap(Scene const& scene);

/// Width, across the second axis, of the part of the membrane whose gap to the seat is within a
/// tenth of a cell of the smallest.
/// @pre the scene has a membrane and a contact
double land_width(Scene const& scene);

}  // namespace velum::cases
