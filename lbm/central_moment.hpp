#pragma once
#include "lbm/central_shift.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Central moments: shear moments relax at the shear rate, the trace at rate 1, and all higher
/// central moments about the velocity after collision are set to their equilibrium: zero but for
/// kxxyy = rho/9 and kxxyyzz = rho/27; raw moments follow by the binomial shift.
/// Geier, Greiner & Korvink, Phys. Rev. E 73 (2006) 066705, doi:10.1103/PhysRevE.73.066705.
/// D3Q19 has no corner velocities to tell kxxyy from the second moments: what is at equilibrium
/// there is the part of it that is orthogonal to them, with the lattice's weights,
///   kxxyy = rho/9 + (dxx + dyy)/3 - dzz/6,  daa = kaa - rho/3 after collision;
/// with rho/9 alone waves grow at rest below nu of about 5e-3, by 1.5e-3 a step at 1e-3.
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

  /// (dxx + dyy)/3 - dzz/6 of the fourth moment number e, whatever its axes are called.
  template <Lattice L, int e>
  KOKKOS_FORCEINLINE_FUNCTION static Real orthogonal_part(Moments<L, Real> const& k)
  {
    Real sum = 0;
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      constexpr int aa = second_moment<L>(a, a);
      constexpr Powers powers = L::powers(e);
      constexpr Real share = powers[a] == 2 ? Real(1) / 3 : -Real(1) / 6;
      sum += share * (k.m[aa] - Real(1) / 3 * k.rho());
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
      if constexpr (L::Q == 19 && rest > 0) k.m[e] += orthogonal_part<L, e>(k);
      out.m[e] = shifted<L, e, CentralMoment>(k, u);
    });
  }
};

}  // namespace velum::lbm
