#pragma once
#include "core/vec.hpp"

#include <memory>
#include <vector>

namespace velum::core {

struct Shape;

/// Rigid geometry as a signed distance: positive in the fluid, negative in the solid, zero on the
/// wall. An immutable tree of shapes behind a shared pointer: cheap to copy, safe to read from many
/// threads, host only. A default-constructed Obstacle is empty: infinitely far from everywhere.
///
/// Lengths are in whatever unit the shapes were given in. In a meridional plane a box is a
/// cylinder and a polygon a revolved profile; a solid that contains a piece of the axis should be
/// drawn across it (to negative radii), or the axis itself would count as its surface.
struct Obstacle {
  std::shared_ptr<Shape const> shape;
};

/// The piece of surface nearest to a point: how far it is, and its unit normal out of the solid,
/// which is the gradient of the distance wherever that exists. On the ridges where it does not
/// (points equally far from two surfaces) one of the candidates is chosen, always the same one.
struct NearestSurface {
  double distance;
  Vec2 normal;
};

/// Signed distance and normal together, at the price of one.
NearestSurface nearest_surface(Obstacle const& obstacle, Vec2 const& p);
/// Signed distance of p from the obstacle.
double distance(Obstacle const& obstacle, Vec2 const& p);
/// Unit normal, out of the solid, of the surface nearest to p; zero for an empty obstacle.
Vec2 gradient(Obstacle const& obstacle, Vec2 const& p);

/// Axis-parallel rectangle from corner lo to corner hi; its corners are rounded inside this outline
/// with radius `round`, at most half the shorter side. Distance exact everywhere.
Obstacle box(Vec2 const& lo, Vec2 const& hi, double round = 0);

/// Disc; in a meridional plane the section of a ring, or of a ball where the centre is on the axis.
Obstacle disc(Vec2 const& centre, double radius);

/// Simple polygon through the corners, in either direction, closed by itself, not necessarily
/// convex. Distance exact everywhere when round = 0.
///
/// With round > 0 the convex corners are rounded inside the outline: every edge moves inwards by
/// `round`, and what is left is grown by `round` again, so the straight parts stay where they were.
/// Concave corners stay sharp, and beside them, inside the solid, the depth is a lower bound.
/// @throws InputError  fewer than three corners, a repeated corner, an outline that crosses itself,
///                     or one too narrow for the radius (at an acute concave corner the moved edges
///                     meet far inside, and must still find room there)
Obstacle polygon(std::vector<Vec2> const& corners, double round = 0);

/// Solid of any part: min of the distances. Exact outside; inside overlapping parts a lower bound
/// of the depth.
Obstacle unite(std::vector<Obstacle> parts);

/// Solid of a that is not in b: max(a, -b). Zero set and sign exact; away from the surface a lower
/// bound of the distance where the nearest point of one lies in the other.
Obstacle subtract(Obstacle a, Obstacle b);

/// The obstacle moved by the map p -> scale p + shift, scale > 0; distances scale with it. Turns
/// metres into lattice units and shifts geometry against the lattice.
Obstacle transformed(Obstacle obstacle, double scale, Vec2 const& shift);

}  // namespace velum::core
