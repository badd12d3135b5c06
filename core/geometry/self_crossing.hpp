#pragma once
#include "core/geometry/triangle_tree.hpp"

namespace velum::core {

/// Number of edges that go through a triangle somewhere between their ends: zero unless the surface
/// crosses itself, as the parts of an assembly do that were not united. Edges that end on a
/// triangle, lie in it or pass along its side do not count.
int crossing_edges(TriangleMesh const& mesh, TriangleTree const& tree);

}  // namespace velum::core
