#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

namespace velum::structure {

/// A linear spring that presses the middle of a body (a Membrane or a Sheet) in the -x direction.
struct Spring {
  double stiffness;  ///< force per length
  double free_length;
  double installed_length;  ///< while the body is in its reference position
  double radius;            ///< it acts on the patch of reference radius |y| <= radius, or of that
                            ///< distance from the line y = z = 0
};

/// Share of each node in the patch: w_a = integral of N_a over the part of the reference ring area
/// within the radius, divided by that area; an element cut by the edge counts with its inner part,
/// a triangle's cut being straight. Sums to one.   [N]
/// Throws InputError where no part of the body lies in the patch.
Eigen::VectorXd patch_weights(Membrane const& m, double radius);
Eigen::VectorXd patch_weights(Sheet const& s, double radius);

/// Axial force of the spring at the positions x (negative: towards -x):
///   F = -k (L0 - Li - d),   d = -sum_a w_a (x_a - X_a),
/// d being the mean displacement of the patch towards -x, by which the spring has grown longer.
template <class Body>
double spring_force(Body const& m, Spring const& spring, Eigen::VectorXd const& weights,
                    Eigen::VectorXd const& x);

/// The spring as a load: F w_a on each node; tangent -k w w^T. Keeps its own copies.
template <class Body>
Load spring_load(Body const& m, Spring const& spring);

}  // namespace velum::structure
