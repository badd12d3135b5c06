#pragma once
#include "cases/app/scene.hpp"
#include "core/obstacle.hpp"

#include <string>

namespace velum::cases {

/// A solid of the scene, shifted to its place; lengths in metres.
core::Obstacle solid(Scene const& scene, std::string const& name);

/// All solids together: the union of those that add, without those that subtract.
core::Obstacle all_solids(Scene const& scene);

/// A side of the lattice box: the axis that crosses it, and whether it lies at `to` or at `from`.
struct BoxSide {
  int axis;
  bool upper;
};

/// "x-", "x+", "y-" or "y+" as a side of the box; nothing for the name of a solid.
std::optional<BoxSide> box_side(std::string const& side);

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
