#pragma once
#include "lbm/hermite_closure.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Central moments: shear moments relax at the shear rate, the trace at rate 1, and all higher
/// central moments about the velocity after collision go to their equilibrium.
/// Geier, Greiner & Korvink, Phys. Rev. E 73 (2006) 066705, doi:10.1103/PhysRevE.73.066705.
///
/// In the plane that is zero but for kxxyy = rho/9. In space it is that of the part orthogonal to
/// the second moments (lbm/hermite_closure.hpp): with kxxyy = rho/9 waves grow at rest on D3Q19
/// below nu of about 5e-3, by 1.5e-3 a step at 1e-3, and on D3Q27 flow along the edges between
/// walls does below 1e-3 (tests/lbm/edges_between_walls_are_stable.cpp).
/// The separate rate of the trace is what keeps tau -> 1/2 stable: it damps the acoustic waves that
/// start-up and corners of the wall send out.
template <class Real>
struct CentralMoment {
  Real omega;

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real) const { return 1; }

  template <Lattice L, class Site>
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<L, Real> const&, Moments<L, Real>& out,
                                          Site const&) const
  {
    if constexpr (L::D == 3) return close_by_hermite(out);
    auto const u = velocity(out);
    Moments<L, Real> k = central_second_moments(out, u);
    core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
      constexpr int e = second_order_end<L> + h;
      k.m[e] = Real(rest_moment<L>(L::powers(e))) * out.rho();
      out.m[e] = raised<L, e>(out, k, u);
    });
  }
};

}  // namespace velum::lbm
