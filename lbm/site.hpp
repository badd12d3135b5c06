#pragma once
#include "core/vec.hpp"

namespace velum::lbm {

/// What the second moments of a site decided, for the rule that sets its higher ones: mid-step
/// density less 1 and velocity, sources of momentum and mass, local shear rate (it differs from
/// omega where the eddy viscosity acts).
template <class Real, int D>
struct Site {
  Real rho;
  core::Vec<Real, D> u;
  core::Vec<Real, D> S;
  Real Q;
  Real shear;
};

}  // namespace velum::lbm
