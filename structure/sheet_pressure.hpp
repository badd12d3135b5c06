#pragma once
#include "structure/load.hpp"
#include "structure/sheet.hpp"

namespace velum::structure {

/// Follower pressure on the plus side of each triangle (negative: on the minus side): -p n on the
/// deformed area, a third to each corner, which is the exact integral of the linear shape
/// functions; tangent exact. It is the gradient of -p V where the rim is held.
/// @param s, pressure  kept by reference: must outlive the load; may change   pressure: [T]
Load pressure_load(Sheet const& s, Eigen::VectorXd const& pressure);

/// The same of a pressure that varies within the triangles, given by what it hands to the corners:
/// W_ae = (1/A_e) integral of p N_a dA. A triangle stays flat, so that these shares stand while it
/// moves; 1/3 of a uniform pressure.   [3][T]
using CornerPressure = Eigen::Matrix3Xd;
Load pressure_load(Sheet const& s, CornerPressure const& pressure);

/// Volume swept from the undeformed to the current state towards the plus sides, the rim's own
/// sweep seen from the origin included (none where the rim is held).
double swept_volume(Sheet const& s, Eigen::VectorXd const& x);

}  // namespace velum::structure
