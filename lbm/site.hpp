#pragma once
#include "core/vec.hpp"

namespace velum::lbm {

/// What the second moments of a site decided, for the rule that sets its higher ones: mid-step
/// density less 1 and velocity, sources of momentum and mass, local shear rate (it differs from
/// omega where the eddy viscosity acts).
/// @tparam sources  whether S and Q may differ from zero: the compiler cannot know that their
///                  products vanish, for they would not if a velocity were infinite
template <class Real, int D, bool sources>
struct Site {
  static constexpr bool has_sources = sources;
  Real rho;
  core::Vec<Real, D> u;
  core::Vec<Real, D> S;
  Real Q;
  Real shear;
};

}  // namespace velum::lbm
