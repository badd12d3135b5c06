#pragma once
#include "structure/sheet.hpp"

#include <array>
#include <vector>

namespace velum::structure {

/// What lies across the edges of a triangle. Side k of a triangle runs from its corner k to the
/// next.
struct Neighbour {
  static constexpr int rim = -1;      ///< nothing
  static constexpr int crowded = -2;  ///< more than one triangle
  int triangle;
  int side;       ///< of that triangle
  bool same_way;  ///< both run along the edge the same way: they disagree about the plus side
};

/// Neighbours of each triangle across its three sides.   [T]
/// @throws InputError  a triangle has a corner twice, or one that is no point of the mesh
std::vector<std::array<Neighbour, 3>> neighbours(TriangleMesh const& mesh);

/// Turns triangles over until all of one part agree with the first of it about the plus side, from
/// which pressure is counted; a part is what hangs together by edges.
/// @return how many were turned over
/// @throws InputError  an edge of more than two triangles; a surface with one side only, such as
///                     Moebius's strip
int agree_on_sides(TriangleMesh& mesh);

}  // namespace velum::structure
