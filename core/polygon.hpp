#pragma once
#include "core/vec.hpp"

#include <vector>

namespace velum::core {

/// Corners of a closed outline, joined in order and last to first.
using Outline = std::vector<Vec2>;

/// Area enclosed, positive when the corners run counter-clockwise (shoelace formula).
double signed_area(Outline const& outline);

/// True when no two edges touch except neighbours at their common corner.
bool is_simple(Outline const& outline);

/// True when p is inside: parity of the edges crossed by the ray from p along the first axis, each
/// edge owning its lower end only, so that a ray through a corner counts right.
bool contains(Outline const& outline, Vec2 const& p);

/// The point of the outline nearest to p and the unit outward normal of the edge it lies on.
/// @pre the outline runs counter-clockwise
struct OutlinePoint {
  Vec2 point;
  Vec2 edge_normal;
};
OutlinePoint nearest_point(Outline const& outline, Vec2 const& p);

/// Every edge moved inwards by `offset` and cut at its moved neighbours (a true inward offset:
/// convex corners stay sharp, and so do concave ones).
/// @pre the outline is simple and runs counter-clockwise
/// @throws InputError when an edge or a neck would vanish
Outline inset(Outline const& outline, double offset);

}  // namespace velum::core
