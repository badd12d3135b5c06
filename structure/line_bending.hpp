#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet_bending.hpp"

#include <memory>
#include <vector>

namespace velum::structure {

/// Bending of a chain of line elements about one node, without rotations as unknowns: the curvature
/// along the meridian from the slopes before and behind, and around the axis from the tilt,
///   k1 = n . (x'+ - x'-) / L,   k2 = -n_r y / Y^2,   x' = dx/dS,
/// n the normal of the mean slope, L the mean length, S and Y of the undeformed chain. On the axis
/// the mirror image continues the chain, and k2 = k1. Energy
///   A/2 D (k1^2 + k1 k2 + k2^2) of the differences from the undeformed state,   D = mu H^3/3,
/// that of a plate of an incompressible solid, E = 3 mu and nu = 1/2 (Timoshenko & Woinowsky-
/// Krieger, Theory of Plates and Shells (1959), section 15); planar k2 = 0, plane strain. An end
/// that is free to turn carries no moment along the meridian: k1 = -k2/2 there, which leaves
/// A/2 D 3/4 k2^2 over the half element, k2 of the element's own tilt; planar nothing.
struct BendingNode {
  using Map =
      Eigen::Matrix<double, 2, 6>;  ///< of the coordinates of the nodes before, here, behind

  int node;
  bool before, behind;  ///< whether there are elements on either side, or images of them
  bool on_axis;         ///< the node before is the image of that behind
  /// tangent = map times the coordinates + what a clamped end holds; the same for (x'+ - x'-) / L
  Map tangent, turn;
  Eigen::Vector2d tangent_held, turn_held;
  double Y;                ///< 0 where there is no k2: planar, or a clamped end
  double area, stiffness;  ///< A, D
  double k1, k2;           ///< of the undeformed state
  Eigen::Matrix2d law;     ///< energy A/2 D e . law e of e = (k1, k2) less those
};
using LineBending = std::vector<BendingNode>;

/// @param rim  how ends whose node is held may turn
LineBending line_bending(Membrane const& m, Rim rim);

double bending_energy(LineBending const& b, Eigen::VectorXd const& x);

/// The bending as a load, with its exact tangent. Keeps b by reference, or shares it.
Load bending_load(LineBending const& b);
Load bending_load(std::shared_ptr<LineBending const> b);

}  // namespace velum::structure
