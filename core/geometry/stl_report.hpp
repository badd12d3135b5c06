#pragma once
#include "core/geometry/mesh_distance.hpp"
#include "core/geometry/thickness.hpp"

#include <optional>
#include <string>

namespace velum::core {

/// What a mesh is and what a lattice of spacing dx will see of it. SI units.
struct StlReport {
  int triangles, degenerate, vertices;
  MeshTopology topology;
  Normals normals;
  Bounds bounds;
  double area;
  std::optional<double> volume;  // none where the surface has no definite inside
  int crossing_edges;            // that go through a triangle: the surface crosses itself
  Thickness thinnest;            // see there how it is measured; searched up to the diagonal
  SignRule sign_rule;            // of mesh_distance()
  double dx;
};

/// @pre the mesh has a triangle, dx > 0
StlReport report(TriangleMesh const& mesh, double dx);

/// The report in a few lines, with a line "warning: ..." for each thing that will go wrong: a
/// surface that is not closed or crosses itself, normals that point inward, a wall or gap under two
/// cells, which the lattice closes or loses depending on how it lies.
std::string text(StlReport const& report);

}  // namespace velum::core
