#pragma once
#include <Eigen/Core>

namespace velum::structure {

/// Volumes of fluid that a body closes in, as its sub-steps feel them: their pressures push the
/// body with A p' and follow, within a sub-step of length h,
///   C (p' - p) / h = q - G p' - A^T v',
/// what flows in less what the body sweeps. Volume and pressure in the units of the body.
struct Enclosures {
  Eigen::MatrixXd area;         ///< A: derivative of each volume by the positions   [dN][m]
  Eigen::VectorXd compliance;   ///< C: volume stored per pressure, 0 or more        [m]
  Eigen::MatrixXd conductance;  ///< G: positive semi-definite                       [m][m]
  Eigen::VectorXd inflow;       ///< q: what would flow in at pressure zero          [m]
  Eigen::VectorXd pressure;     ///< p: before the step, then after it               [m]
  Eigen::VectorXd mean;         ///< of p' over the sub-steps, set by the step       [m]
};

}  // namespace velum::structure
