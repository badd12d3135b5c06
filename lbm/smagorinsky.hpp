#pragma once
#include <cmath>

#include "lbm/moments.hpp"

namespace velum::lbm {

/// Local relaxation rate with the eddy viscosity nu_t = (C dx)^2 |S|, |S| from the site's own
/// non-equilibrium deviator:
///   tau = (tau0 + sqrt(tau0^2 + 18 C^2 |Pi| / rho)) / 2,  |Pi| = sqrt(2 Pi:Pi).
/// Hou, Sterling, Chen & Doolen, Fields Inst. Commun. 6 (1996) 151.
/// @param constant_squared  C^2; zero switches the model off without a branch
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real smagorinsky_rate(Real omega, Real N_neq, Real Pxy_neq, Real rho,
                                                  Real constant_squared)
{
  using std::sqrt;
  Real const tau = 1 / omega;
  Real const magnitude = sqrt(N_neq * N_neq + 4 * Pxy_neq * Pxy_neq);
  return 2 / (tau + sqrt(tau * tau + 18 * constant_squared * magnitude / (1 + rho)));
}

}  // namespace velum::lbm
