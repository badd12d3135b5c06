#pragma once
#include "lbm/fluid.hpp"
#include "lbm/hermite_closure.hpp"

namespace velum::lbm {

/// Share 1 - rate of the moments of third and fifth order that survives a collision,
///   1/rate - 1/2 = (magic / d + x/2) / (1 + x),   d = tau - 1/2,  x = (|u| / (robust_from nu))^2.
/// Where the fluid is slow the product of (1/rate - 1/2) and d is `magic`, that of two relaxation
/// times (lbm/trt.hpp): the friction and the place of a wall then do not depend on the viscosity,
/// and interpolated walls feed no wave along them, at any q and down to tau = 1/2
/// (tests/lbm/still_water_stays_still.cpp); with rate 1 they do for q below 0.003. Where it is fast
/// the rate is 1: moments that hardly relax lose a shear layer at cell Reynolds numbers of some
/// hundred. Solved for 1 - rate that is a / (b + |u|^2) with two constants. The viscosity is the
/// fluid's own: where eddies act the fluid is fast.
template <class Real>
struct OddShare {
  Real a, b;

  KOKKOS_FUNCTION OddShare(Real omega, Real magic)
  {
    Real const d = 1 / omega - Real(0.5), per = Real(robust_from * robust_from / 9);
    a = per * d * (magic - d / 2);
    b = per * d * (magic + d / 2);
  }
  KOKKOS_FORCEINLINE_FUNCTION Real operator()(Real u2) const { return a / (b + u2); }
  /// The same with the division in single precision, half its time: it is a rate, not a balance. In
  /// space the conversions cost more than they save.
  KOKKOS_FORCEINLINE_FUNCTION Real quick(Real u2) const { return a * Real(1 / float(b + u2)); }
};

/// Powers without the square along one direction.
KOKKOS_FUNCTION constexpr Powers without_square(Powers e, int a)
{
  e.p[a] -= 2;
  return e;
}

/// Adds to `out`, closed without odd central moments, the share `left` of those of `in` about its
/// own velocity u_in: of the third order k_e; of the fifth the Hermite moment m_aabbc - (m_aac +
/// m_bbc)/3 + j_c/9, which an equilibrium has not got but for u^5, and what the third add to it,
/// (k_aac + k_bbc)/3. What they add to the fourth order goes with the velocity and is left out: odd
/// moments are kept only where |u| is below robust_from nu.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION void keep_odd_moments(Moments<L, Real> const& in, Moments<L, Real>& out,
                                                  core::Vec<Real, L::D> const& u_in, Real left)
{
  Real const third = Real(1) / 3;
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
    if constexpr (L::powers(e).order() == 5) {
      out.m[e] += left * in.m[e];
      core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
        constexpr Powers full = L::powers(second_order_end<L> + h);
        if constexpr (full[a] == 2) {
          constexpr int pair = moment_index<L>(without_square(full, a));
          out.m[e] += third * (kept.m[pair] - left * in.m[pair]);
        } else {
          out.m[e] += third * third * left * in.j(a);
        }
      });
    }
  });
}

}  // namespace velum::lbm
