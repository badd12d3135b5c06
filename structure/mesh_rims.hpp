#pragma once
#include "structure/mesh_neighbours.hpp"

namespace velum::structure {

/// Closed loops of sides with nothing across. From a side to the next they go around the triangles
/// at a point, so that discs which touch in a point have a rim each.
/// @pre no edge has more than two triangles
int rim_loops(std::vector<std::array<Neighbour, 3>> const& across);

/// Points of the rim that lie in the place of another point of it: where they should be one, the
/// sheet is slit open. Same place: nearer than 1e-9 of the mesh's size.
int slit_points(TriangleMesh const& mesh);

}  // namespace velum::structure
