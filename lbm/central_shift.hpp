#pragma once
#include "lbm/moments.hpp"

namespace velum::lbm {

/// Whether the moment of powers s takes part in the shift to that of powers e.
KOKKOS_FUNCTION constexpr bool is_part(Powers const& s, Powers const& e)
{
  return s[0] <= e[0] && s[1] <= e[1] && s[2] <= e[2];
}

/// Moment number E about another origin: of the central moments k about the velocity u the raw one,
///   m_e = sum over s <= e of binomial(e, s) u^(e - s) k_s,
/// and of raw moments with -u the central one. All moments are deviations from the rest fluid.
/// @tparam Zero  Zero::vanishes(s): k_s is known to be nothing and is left out
template <Lattice L, int E, class Zero, class Real>
KOKKOS_FORCEINLINE_FUNCTION Real shifted(Moments<L, Real> const& k, core::Vec<Real, L::D> const& u)
{
  Real sum = k.m[E];
  core::static_for<E>([&](auto s) __attribute__((always_inline)) {
    constexpr Powers low = L::powers(s), high = L::powers(E);
    if constexpr (is_part(low, high) && !Zero::vanishes(low)) {
      Real term = k.m[s] + Real(rest_moment<L>(low));
      core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
        constexpr Powers from = L::powers(s), to = L::powers(E);
        if constexpr (to[a] > from[a]) term *= u[a];
        if constexpr (to[a] == from[a] + 2) term *= u[a];
        if constexpr (to[a] == 2 && from[a] == 1) term *= 2;
      });
      sum += term;
    }
  });
  return sum;
}

/// Central second moments, and density, about the velocity u; the first central moments are zero.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION Moments<L, Real> central_second_moments(Moments<L, Real> const& raw,
                                                                    core::Vec<Real, L::D> const& u)
{
  Moments<L, Real> k{};
  Real const n = 1 + raw.rho();
  k.rho() = raw.rho();
  core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
    core::static_for<a + 1>([&](auto b) __attribute__((always_inline)) {
      constexpr int ab = second_moment<L>(a, b);
      k.m[ab] = raw.m[ab] - n * u[a] * u[b];
    });
  });
  return k;
}

/// Velocity after collision.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION core::Vec<Real, L::D> velocity(Moments<L, Real> const& m)
{
  core::Vec<Real, L::D> u;
  Real const v = 1 / (1 + m.rho());
  core::static_for<L::D>([&](auto a) __attribute__((always_inline)) { u[a] = v * m.j(a); });
  return u;
}

}  // namespace velum::lbm
