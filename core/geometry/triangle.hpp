#pragma once
#include "core/vec.hpp"

#include <optional>

namespace velum::core {

/// A triangle as a corner and the two edges from it.
struct CornerAndEdges {
  Vec3 corner, first, second;
};

/// What of a triangle is nearest to a point: its face, the edge from corner k to the next, or
/// corner k.
enum class Part { face, edge, corner };

struct ClosestPoint {
  Vec3 point;
  Part part;
  int k;  // of the edge or corner
};

/// Point of the triangle nearest to p (Ericson, Real-Time Collision Detection, 2005, section
/// 5.1.5): which of the seven regions of the triangle's plane p is above.
ClosestPoint closest_point(CornerAndEdges const& triangle, Vec3 const& p);

/// Where a ray goes through a triangle: at origin + t direction, t of either sign.
struct Crossing {
  double t;
  bool from_behind;  // the ray runs along the normal, not against it
};

/// Crossing of ray and triangle (Moller and Trumbore, J. Graphics Tools 2, 1997,
/// doi:10.1080/10867651.1997.10487468); nothing for a ray in the triangle's plane.
std::optional<Crossing> crossing(CornerAndEdges const& triangle, Vec3 const& origin,
                                 Vec3 const& direction);

}  // namespace velum::core
