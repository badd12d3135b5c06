#pragma once
#include <cmath>

#include "lbm/moments.hpp"

namespace velum::lbm {

/// Magnitude sqrt(2 Pi:Pi) of the deviator of the non-equilibrium second moments of a site with
/// velocity u, density n.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION Real deviator_magnitude(Moments<L, Real> const& m, Real n,
                                                    core::Vec<Real, L::D> const& u)
{
  using std::sqrt;
  Real neq[L::D][L::D], trace = 0, sum = 0;
  core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
    core::static_for<L::D>([&](auto b) __attribute__((always_inline)) {
      constexpr int ab = second_moment<L>(a, b);
      neq[a][b] = m.m[ab] - n * u[a] * u[b];
    });
    trace += neq[a][a];
  });
  core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
    neq[a][a] -= trace / L::D;
    core::static_for<L::D>([&](auto b)
                               __attribute__((always_inline)) { sum += neq[a][b] * neq[a][b]; });
  });
  return sqrt(2 * sum);
}

/// Local relaxation rate with the eddy viscosity nu_t = (C dx)^2 |S|, |S| from the site's own
/// non-equilibrium deviator:
///   tau = (tau0 + sqrt(tau0^2 + 18 C^2 |Pi| / rho)) / 2,  |Pi| = sqrt(2 Pi:Pi).
/// Hou, Sterling, Chen & Doolen, Fields Inst. Commun. 6 (1996) 151.
/// @param volume            1 / rho
/// @param constant_squared  C^2; zero leaves omega
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real smagorinsky_rate(Real omega, Real magnitude, Real volume,
                                                  Real constant_squared)
{
  using std::sqrt;
  Real const tau = 1 / omega;
  return 2 / (tau + sqrt(tau * tau + 18 * constant_squared * magnitude * volume));
}

}  // namespace velum::lbm
