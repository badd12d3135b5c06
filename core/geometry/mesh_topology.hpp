#pragma once
#include "core/geometry/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace velum::core {

/// How the triangles of a mesh hang together. A surface is closed when every edge belongs to two
/// triangles that run along it in opposite directions; what is not so is counted, by edges.
struct MeshTopology {
  int open_edges = 0;          // of one triangle
  int non_manifold_edges = 0;  // of more than two
  int flipped_edges = 0;       // of two that run the same way: they disagree about the outside
  int shells = 0;              // pieces that no edge joins
  std::vector<int> shell;      // number of its shell, for each triangle
};

MeshTopology topology(TriangleMesh const& mesh);

/// No way from the inside to the outside, whatever the normals say.
inline bool is_watertight(MeshTopology const& t)
{
  return t.open_edges == 0 && t.non_manifold_edges == 0;
}
inline bool is_closed(MeshTopology const& t) { return is_watertight(t) && t.flipped_edges == 0; }

/// The edge from corner k of a triangle to the next.
struct Edge {
  std::uint64_t place;  // the same for the same two vertices, from both sides
  bool rising;          // the triangle runs from the lower vertex to the higher
};
Edge edge(Triangle const& triangle, int k);

/// The two vertices of an edge, the lower first.
inline std::array<int, 2> vertices_of(Edge const& edge)
{
  return {static_cast<int>(edge.place >> 32), static_cast<int>(edge.place & 0xffffffffu)};
}

}  // namespace velum::core
