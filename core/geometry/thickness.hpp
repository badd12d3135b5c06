#pragma once
#include "core/geometry/orientation.hpp"

#include <optional>

namespace velum::core {

/// Length of a ray between two faces, and the middle of it.
struct Span {
  double length;
  Vec3 middle;
};

struct Thickness {
  std::optional<Span> wall, gap;  // nothing where no ray meets a face opposite
};

/// Thinnest wall and narrowest gap of a solid, by rays: from the centroid of every triangle, cut
/// before into pieces no longer than a fiftieth of the mesh's diagonal, along its normal into the
/// solid for the wall and out of it for the gap. A ray counts when the first face that it meets
/// looks back within 45 degrees; the sides of a corner do not, those of a sharper edge do, and
/// there the length is that at the ray nearest to the edge. Where faces are not parallel the least
/// length is too large by what it changes between two rays. Where the orientation is unknown the
/// normals are taken as they are.
/// @param limit  walls and gaps wider than this are not looked for, m
Thickness thinnest(TriangleMesh const& mesh, MeshTopology const& topology, TriangleTree const& tree,
                   Orientation const& orientation, double limit);

}  // namespace velum::core
