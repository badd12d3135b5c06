#pragma once
#include "core/geometry/bounds.hpp"
#include "core/vec.hpp"

#include <array>
#include <vector>

namespace velum::core {

/// The three corners of a triangle as points.
using Facet = std::array<Vec3, 3>;
/// The three corners of a triangle as indices of vertices; seen from the fluid they run
/// counter-clockwise.
using Triangle = std::array<int, 3>;

/// Surface of a solid as triangles that share their vertices. Lengths in metres.
struct TriangleMesh {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;  // each has an area
  /// Triangles on three different vertices that lie on a line. They are no surface, but their
  /// neighbours' edges meet across them: without them a closed surface would look open.
  std::vector<Triangle> needles;
  int degenerate = 0;  // triangles left out: the needles, and those with fewer than three vertices
};

/// Mesh of the facets: corners nearer than the rounding of single precision at the largest
/// coordinate become one vertex, triangles thinner than that are left out and counted.
/// @pre the coordinates are finite
TriangleMesh merge(std::vector<Facet> const& facets);

/// Corners of triangle t.
Facet facet(TriangleMesh const& mesh, int t);
/// Vector of the area of a facet: along its normal, as long as its area.
Vec3 area_vector(Facet const& facet);

Bounds bounds(TriangleMesh const& mesh);
/// Area of the surface, m2.
double area(TriangleMesh const& mesh);

}  // namespace velum::core
