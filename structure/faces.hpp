#pragma once
#include "core/vec.hpp"
#include "structure/membrane.hpp"

#include <Eigen/Core>

#include <vector>

namespace velum::structure {

/// The two wet faces of a membrane of finite thickness, as polylines of one point per node. They
/// say where the fluid ends; forces per area belong on the mid-surface (pressure_load.hpp says
/// why).
struct Faces {
  std::vector<core::Vec2> normal;       ///< unit, towards the plus side   [N]
  std::vector<double> thickness;        ///< current, H / (l1 l2)          [N]
  std::vector<core::Vec2> plus, minus;  ///< x +- scale h / 2 n            [N]
};

/// Fills faces for the positions x; keeps its memory when called again. At a node between two
/// elements the normal is that of the parabola through the three nodes; on the axis the mirror
/// image continues the chain, so it is axial; at the other ends it is the element's own.
/// @param thickness_scale  1: true faces; 0: both fall on the mid-surface
void locate_faces(Membrane const& m, Eigen::VectorXd const& x, double thickness_scale,
                  Faces& faces);

}  // namespace velum::structure
