#pragma once
#include "lbm/fluid.hpp"
#include "lbm/hermite_closure.hpp"

namespace velum::lbm {

/// Rate of the moments of third and fifth order,
///   1/rate - 1/2 = (magic / (tau - 1/2) + x/2) / (1 + x),   x = (|u| / (robust_from nu))^2.
/// Where the fluid is slow the product of (1/rate - 1/2) and (tau - 1/2) is `magic`, that of two
/// relaxation times (lbm/trt.hpp): the friction and the place of a wall then do not depend on the
/// viscosity, and interpolated walls feed no wave along them, at any q and down to tau = 1/2
/// (tests/lbm/still_water_stays_still.cpp); with rate 1 they do for q below 0.003. Where it is fast
/// the rate is 1: moments that hardly relax lose a shear layer at cell Reynolds numbers of some
/// hundred.
/// @param d   tau - 1/2, eddy viscosity included
/// @param u2  |u|^2
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real odd_rate(Real magic, Real d, Real u2)
{
  // nu = d/3; numerator and denominator times d^2, for one division
  Real const slow = d * d, fast = Real(9 / (robust_from * robust_from)) * u2;
  return (slow + fast) / (magic * d + slow / 2 + fast);
}

/// Powers with that along one direction lowered.
KOKKOS_FUNCTION constexpr Powers less(Powers e, int a, int by)
{
  e.p[a] -= by;
  return e;
}

/// What of the odd moments of `in` survives a collision, added to `out`: of the third order central
/// moments about its own velocity u_in, k_e = (1 - rate) k_e,in; of the fifth the Hermite moment
/// m_aabbc - (m_aac + m_bbc)/3 + j_c/9, which an equilibrium has not got but for u^5. With the
/// third come what they add to the fourth order, with the velocity u, and to the fifth, (k_aac +
/// k_bbc)/3. Terms of second order in u are left out: odd moments are kept only where |u| is below
/// robust_from nu.
/// @pre out was closed without odd central moments
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION void keep_odd_moments(Moments<L, Real> const& in, Moments<L, Real>& out,
                                                  core::Vec<Real, L::D> const& u_in,
                                                  core::Vec<Real, L::D> const& u, Real rate)
{
  Real const third = Real(1) / 3, left = 1 - rate;
  Moments<L, Real> const before = central_second_moments(in, u_in);
  Moments<L, Real> kept;
  core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
    constexpr int e = second_order_end<L> + h;
    if constexpr (L::powers(e).order() == 3) {
      kept.m[e] = left * (in.m[e] - raised<L, e>(in, before, u_in));
      out.m[e] += kept.m[e];
    }
  });
  core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
    constexpr int e = second_order_end<L> + h;
    if constexpr (L::powers(e).order() == 5) out.m[e] += left * in.m[e];
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      constexpr Powers full = L::powers(second_order_end<L> + h);
      if constexpr (full.order() == 4 && full[a] > 0)
        out.m[e] += Real(full[a]) * u[a] * kept.m[moment_index<L>(less(full, a, 1))];
      if constexpr (full.order() == 5 && full[a] == 2) {
        constexpr int pair = moment_index<L>(less(full, a, 2));
        out.m[e] += third * (kept.m[pair] - left * in.m[pair]);
      }
      if constexpr (full.order() == 5 && full[a] == 1) out.m[e] += third * third * left * in.j(a);
    });
  });
}

}  // namespace velum::lbm
