#pragma once
#include <cmath>

#include "lbm/moments.hpp"

namespace velum::lbm {

/// Magnitude sqrt(2 Pi:Pi) of the deviator of the non-equilibrium second moments of a
/// site with velocity u, density n.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION Real deviator_magnitude(Moments<L, Real> const& m, Real n,
                                                    core::Vec<Real, L::D> const& u)
{
  Real trace = 0, diagonal = 0, beside = 0;
  core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
    core::static_for<a + 1>([&](auto b) __attribute__((always_inline)) {
      constexpr int ab = second_moment<L>(a, b);
      Real const neq = m.m[ab] - n * u[a] * u[b];
      if constexpr (a == b) {
        trace += neq;
        diagonal += neq * neq;
      } else {
        beside += neq * neq;
      }
    });
  });
  Real const squared = diagonal - Real(1) / L::D * trace * trace;  // round-off may make it negative
  using std::sqrt;
  return sqrt(2 * (squared > 0 ? squared : 0) + 4 * beside);
}

/// Local relaxation time with the eddy viscosity nu_t = (C dx)^2 |S|, |S| from the site's own
/// non-equilibrium deviator:
///   tau = (tau0 + r) / 2,  r = sqrt(tau0^2 + a),  a = 18 C^2 |Pi| / rho,  |Pi| = sqrt(2 Pi:Pi).
/// Hou, Sterling, Chen & Doolen, Fields Inst. Commun. 6 (1996) 151.
/// @param volume            1 / rho
/// @param tau               without the eddy viscosity, tau0
/// @param constant_squared  C^2; zero leaves tau
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real smagorinsky_time(Real tau, Real magnitude, Real volume,
                                                  Real constant_squared)
{
  Real const a = 18 * constant_squared * magnitude * volume;
  using std::sqrt;
  return (tau + sqrt(tau * tau + a)) / 2;
}

}  // namespace velum::lbm
