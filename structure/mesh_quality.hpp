#pragma once
#include "structure/sheet.hpp"

#include <string>
#include <vector>

namespace velum::structure {

/// The triangle in which something is smallest or largest.
struct TriangleExtreme {
  double value = 0;
  int triangle = 0;                                 ///< its index
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< its centroid
};

/// What a mesh of triangles is worth to the method. Lengths in metres, angles in degrees.
struct MeshQuality {
  int points, triangles;
  int parts;  ///< pieces that no edge joins
  int rims;   ///< closed loops of edges of one triangle: 0 of a closed surface, 2 of a tube
  bool closed;
  int crowded_edges;       ///< of more than two triangles
  int flipped_edges;       ///< whose two triangles disagree about the plus side
  int slit_points;         ///< points of the rim in the place of another one
  Eigen::Vector3d lo, hi;  ///< corners of the box around the points
  double area;
  double shortest_edge, longest_edge, mean_edge;
  TriangleExtreme smallest_height;  ///< 2 A / longest edge: the stable step falls with it
  TriangleExtreme smallest_angle, largest_angle;
  /// Shape q = 4 sqrt(3) A / (sum of the squared edges): 1 of an equilateral triangle, 0 of none.
  /// Bank and Smith, SIAM J. Numer. Anal. 34 (1997), doi:10.1137/S0036142994265292
  TriangleExtreme worst_shape;
  double mean_shape;
  /// Largest ratio of the sizes of two neighbours; size: root of the mean squared edge.
  TriangleExtreme size_jump;
  int degenerate;  ///< triangles without area: q below 1e-10, which is round-off
};

/// @throws InputError  a mesh without triangles; a triangle that has a corner twice, or one that is
///                     no point of the mesh
MeshQuality mesh_quality(TriangleMesh const& mesh);

/// A few lines of text that say all of it.
std::string text(MeshQuality const& quality);

/// A sentence for each thing that will cost steps, accuracy or the run, and what to do about it.
std::vector<std::string> warnings(MeshQuality const& quality);

}  // namespace velum::structure
