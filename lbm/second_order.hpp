#pragma once
#include "lbm/moments.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Relaxes all moments above the second towards the second-order equilibrium, odd ones at the rate
/// odd and even ones at the rate even; sources enter with the factor 1 - rate/2 (Guo, Zheng & Shi,
/// Phys. Rev. E 65 (2002) 046308, doi:10.1103/PhysRevE.65.046308). The equilibrium of powers e is
///   rho M_e + 3 j_a M_(e+a) + 9/2 rho u_a u_b M_(e+a+b) - 3/2 rho u^2 M_e,
/// M the moments of the weights; less M_e, for moments are deviations.
template <Lattice L, class Real, class Site>
KOKKOS_FORCEINLINE_FUNCTION void relax_higher(Moments<L, Real> const& in, Moments<L, Real>& out,
                                              Site const& s, Real odd, Real even)
{
  Real const n = 1 + s.rho;
  core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
    constexpr int k = second_order_end<L> + h;
    constexpr Powers e = L::powers(k);
    Real const rate = e.order() % 2 == 0 ? even : odd;
    Real equilibrium = 0, source = 0;
    if constexpr (e.order() % 2 == 1) {
      core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
        constexpr double M = rest_moment<L>(L::powers(second_order_end<L> + h) + unit(a));
        if constexpr (M != 0) {
          equilibrium += Real(3 * M) * n * s.u[a];
          source += Real(3 * M) * s.S[a];
        }
      });
    } else {
      constexpr double rest = rest_moment<L>(e);
      equilibrium = Real(rest) * s.rho;
      source = Real(rest) * s.Q;
      core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
        core::static_for<a + 1>([&](auto b) __attribute__((always_inline)) {
          constexpr Powers power = L::powers(second_order_end<L> + h);
          constexpr double M = 4.5 * (a == b ? 1 : 2) * rest_moment<L>(power + unit(a) + unit(b)) -
                               (a == b ? 1.5 * rest_moment<L>(power) : 0.0);
          if constexpr (M > 1e-12 || M < -1e-12) {
            Real const uu = s.u[a] * s.u[b];
            equilibrium += Real(M) * n * uu;
            source += Real(M) * (s.u[a] * s.S[b] + s.u[b] * s.S[a] - uu * s.Q);
          }
        });
      });
    }
    out.m[k] = in.m[k] + rate * (equilibrium - in.m[k]);
    if constexpr (Site::has_sources) out.m[k] += (1 - rate / 2) * source;
  });
}

}  // namespace velum::lbm
