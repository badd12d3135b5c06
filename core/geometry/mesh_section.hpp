#pragma once
#include "core/geometry/triangle_mesh.hpp"

#include <filesystem>
#include <vector>

namespace velum::core {

/// The plane on which coordinate `axis` (0 x, 1 y, 2 z) has the value `at`, in metres.
struct CutPlane {
  int axis;
  double at;
};

/// Coordinates within the plane, in the order that keeps them right-handed: y z, z x, x y.
inline int first_in_plane(CutPlane const& plane) { return (plane.axis + 1) % 3; }
inline int second_in_plane(CutPlane const& plane) { return (plane.axis + 2) % 3; }

/// A line of the section, in the coordinates within the plane; a closed one ends in its first
/// point. Where normals point outward the solid is on its left.
using Polyline = std::vector<Vec2>;

/// Section of the mesh with a plane. Vertices in the plane count as above it, so that a face in the
/// plane is not drawn twice, or not at all where the solid lies above it.
std::vector<Polyline> section(TriangleMesh const& mesh, CutPlane const& plane);

/// Rows "line, point": the number of the line and the coordinates of its points, in metres.
/// @throws InputError  the file cannot be written
void write_section(std::filesystem::path const& file, std::vector<Polyline> const& lines,
                   CutPlane const& plane);

}  // namespace velum::core
