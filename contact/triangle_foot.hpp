#pragma once
#include <array>

#include "core/geometry/triangle.hpp"
#include "core/geometry/triangle_mesh.hpp"

namespace velum::contact {

/// Where on a triangle the point of it lies that is nearest to a point x in space.
struct Foot {
  core::Part part;               ///< face, edge or corner
  int k;                         ///< of the edge (from corner k to the next) or corner
  std::array<double, 3> weight;  ///< of the corners: q = sum of weight x corner
  double height;                 ///< |x - q|, negative on the minus side
  core::Vec3 up;                 ///< unit vector with x - q = height up
  double cosine;                 ///< of the angle between x - q and the surface's normal at q
  bool clear;                    ///< x is seen within 60 degrees of the normal: the sign of the
                                 ///< height means a side of the surface
};

/// Foot of x on a triangle.
/// @param corners  counter-clockwise seen from the plus side
/// @param normals  of the surface at the corners, unit: they tell the side of x where an edge or a
///                 corner is nearest
Foot foot(core::Facet const& corners, core::Vec3 const& x, core::Facet const& normals);

/// The same on the triangle's whole plane: the shares may lie outside 0 to 1.
Foot foot_on_plane(core::Facet const& corners, core::Vec3 const& x);

/// Signed distance of x from the surface, and its derivative: by x the vector N, by corner a
/// -weight_a N. The nearest point of face, edge and corner alike moves along the surface only, so
/// this is the exact gradient for all three.
struct SignedHeight {
  double distance;
  core::Vec3 normal;  ///< N, unit
};

/// @param side  of the surface that x belongs to, 1 or -1; 0 where none is known: the distance is
///              then without a sign, as it is beside a rim
SignedHeight signed_height(Foot const& f, int side);

/// Derivatives by the nine coordinates of the corners, behind the three of x.
using Matrix12 = std::array<std::array<double, 12>, 12>;

/// Second derivative of the signed distance d by x and the corners. With the weights w = (1,
/// -weight) and the gradients b of the shape functions in the plane of the face or along the edge
/// (zero for x, and at a corner),
///   -w_j N b_i^T - w_i b_j N^T - d (b_i . b_j) N N^T + w_i w_j P / d,
/// P the projection on the directions across both N and the face or edge: of a face nothing, of an
/// edge one, of a corner two. For the face it is the one of Wriggers, Computational Contact
/// Mechanics (2006), section 9.2.
Matrix12 second_derivative(core::Facet const& corners, Foot const& f, SignedHeight const& h);

}  // namespace velum::contact
