#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"

#include <memory>

namespace velum::structure {

/// A rigid plane across the axis that the plus face of a membrane comes up against.
struct LiftStop {
  double position;  ///< of the plane, along the axis
  double radius;    ///< nodes of reference radius y <= radius meet it
  /// Penalty: pressure per depth, on the undeformed area of each node. Shared, so that it follows
  /// that of the seat wherever a march changes it.
  std::shared_ptr<double const> stiffness;
};

/// Force by which the stop presses the membrane towards -x at the positions x, by penalty:
///   F = sum_a k A_a max(0, x_a + H_a/2 - position),
/// A_a the undeformed area of the node, H_a the undeformed thickness there: the face is taken as
/// square to the axis.
double stop_force(Membrane const& m, LiftStop const& stop, Eigen::VectorXd const& x);

/// How far up the face of these nodes comes.
double highest_face(Membrane const& m, LiftStop const& stop);

/// The stop as a load with its exact tangent. Keeps its own copies.
Load stop_load(Membrane const& m, LiftStop const& stop);

}  // namespace velum::structure
