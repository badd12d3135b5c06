#pragma once
#include "lbm/central_shift.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Central moments: shear moments relax at the shear rate, the trace at rate 1, and all higher
/// central moments about the velocity after collision are set to their equilibrium: zero but for
/// kxxyy = rho/9 and kxxyyzz = rho/27; raw moments follow by the binomial shift.
/// Geier, Greiner & Korvink, Phys. Rev. E 73 (2006) 066705, doi:10.1103/PhysRevE.73.066705.
/// In space what is set to equilibrium is the part of them that is orthogonal, with the lattice's
/// weights, to the second moments, so that these are not damped a second time:
///   kxxyy = rho/9 + (dxx + dyy)/3 [D3Q19: - dzz/6],  kxxyyzz = rho/27 + (dxx + dyy + dzz)/9,
/// daa = kaa - rho/3 after collision; in the plane dxx + dyy = 0. On D3Q19, which has no corner
/// velocities to tell kxxyy from the second moments, waves otherwise grow at rest below nu of about
/// 5e-3, by 1.5e-3 a step at 1e-3.
/// The separate rate of the trace is what keeps tau -> 1/2 stable: it damps the acoustic waves that
/// start-up and corners of the wall send out.
template <class Real>
struct CentralMoment {
  Real omega;

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real) const { return 1; }

  /// Central moments with an odd power vanish, except the shear moments.
  KOKKOS_FUNCTION static constexpr bool vanishes(Powers const& e)
  {
    bool const odd = e[0] % 2 == 1 || e[1] % 2 == 1 || e[2] % 2 == 1;
    return odd && e.order() != 2;
  }

  /// What the second moments bring to the even moment number e.
  template <Lattice L, int e>
  KOKKOS_FORCEINLINE_FUNCTION static Real orthogonal_part(Moments<L, Real> const& k)
  {
    constexpr Powers powers = L::powers(e);
    constexpr Real own = powers.order() == 4 ? Real(1) / 3 : Real(1) / 9;
    Real sum = 0;
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      constexpr int aa = second_moment<L>(a, a);
      constexpr Powers p = L::powers(e);
      constexpr Real other = L::Q == 19 ? -Real(1) / 6 : Real(0);
      constexpr Real share = p[a] == 2 ? own : other;
      sum += share * (k.m[aa] - k.rho() / 3);
    });
    return sum;
  }

  template <Lattice L>
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<L, Real> const&, Moments<L, Real>& out,
                                          Site<Real, L::D> const&) const
  {
    auto const u = velocity(out);
    Moments<L, Real> k = central_second_moments(out, u);
    core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
      constexpr int e = second_order_end<L> + h;
      constexpr double rest = rest_moment<L>(L::powers(second_order_end<L> + h));
      k.m[e] = rest > 0 ? Real(rest) * out.rho() : Real(0);
      if constexpr (L::D == 3 && rest > 0) k.m[e] += orthogonal_part<L, e>(k);
      out.m[e] = shifted<L, e, CentralMoment>(k, u);
    });
  }
};

}  // namespace velum::lbm
