#pragma once
#include "structure/sheet.hpp"

#include <vector>

namespace velum::structure {

/// Meshes made in the program, in the plane x = 0 (the tube along x), the plus side towards +x
/// (outwards of a tube). Lengths in any unit. They throw InputError where a size or number is not
/// positive.

/// Places from a to b whose steps grow by a constant factor, so that the last is `grading` times
/// the first; 1: equal steps.   [n + 1]
std::vector<double> graded(double a, double b, int n, double grading = 1);

/// Disc about the origin: a centre and rings of 6, 12, 18 ... points, nearly equilateral triangles
/// where the radii are equally far apart.
/// @param radii  of the rings, ascending, the last the rim; the first 0 is left out
TriangleMesh disc_mesh(std::vector<double> const& radii);

/// Ring between the first and the last radius.
TriangleMesh annulus_mesh(std::vector<double> const& radii, int sectors);

/// Rectangle over the given places along y and z.
TriangleMesh strip_mesh(std::vector<double> const& y, std::vector<double> const& z);

/// Tube about the x axis, open at its ends.
TriangleMesh tube_mesh(double radius, std::vector<double> const& x, int sectors);

/// Points of the mesh that lie on an edge of one triangle only, in ascending order.
std::vector<int> rim_points(TriangleMesh const& mesh);

}  // namespace velum::structure
