#pragma once
#include "core/geometry/bounds.hpp"
#include "core/geometry/triangle.hpp"
#include "core/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace velum::core {

/// Tree of boxes around the triangles of a mesh, halved at the median of the centroids along the
/// longest side: the nearest triangle and the triangles on a ray are found in a time that grows
/// with the logarithm of their number. Safe to read from many threads.
struct TriangleTree {
  struct Node {
    Bounds bounds;
    int first;  // of a leaf: its first triangle; of a fork: its second child, the first follows it
    int count;  // triangles of a leaf, zero for a fork
  };
  std::vector<Node> nodes;
  std::vector<CornerAndEdges> triangles;  // in the order of the leaves
  std::vector<int> number;                // of each of them in the mesh
};

TriangleTree make_tree(TriangleMesh const& mesh);

struct NearestTriangle {
  int triangle;
  ClosestPoint closest;
};

/// The triangle nearest to p and its point there.
/// @pre the tree is not empty
NearestTriangle nearest(TriangleTree const& tree, Vec3 const& p);

/// Hands every triangle that the ray crosses with 0 <= t <= limit to visit(triangle, crossing), in
/// no order; what visit returns is the limit from then on.
template <class Visit>
void visit_crossings(TriangleTree const& tree, Vec3 const& origin, Vec3 const& direction,
                     double limit, Visit const& visit)
{
  Vec3 const inverse{1 / direction[0], 1 / direction[1], 1 / direction[2]};
  auto const meets = [&](Bounds const& box) {
    double enter = 0, leave = limit;
    for (int k = 0; k < 3; ++k) {
      // Not a number where the ray runs in a side of the box: min and max then keep what they have.
      double const a = (box.lo[k] - origin[k]) * inverse[k];
      double const b = (box.hi[k] - origin[k]) * inverse[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  };
  std::array<int, 64> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    auto const at = static_cast<std::size_t>(stack[--waiting]);
    auto const& node = tree.nodes[at];
    if (!meets(node.bounds)) continue;
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = static_cast<int>(at) + 1;
      continue;
    }
    for (auto k = static_cast<std::size_t>(node.first),
              end = k + static_cast<std::size_t>(node.count);
         k < end; ++k)
      if (auto const hit = crossing(tree.triangles[k], origin, direction))
        if (hit->t >= 0 && hit->t <= limit) limit = visit(tree.number[k], *hit);
  }
}

}  // namespace velum::core
