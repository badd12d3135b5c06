#pragma once
#include "lbm/hermite_closure.hpp"
#include "lbm/odd_moments.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Central moments: shear moments relax at the shear rate, the trace at rate 1, odd ones at the
/// rate of lbm/odd_moments.hpp, and the even ones above the second, about the velocity after
/// collision, go to their equilibrium.
/// Geier, Greiner & Korvink, Phys. Rev. E 73 (2006) 066705, doi:10.1103/PhysRevE.73.066705.
///
/// In the plane that is kxxyy = (rho + Q)/9 of the mid-step density and the source of mass about an
/// axis: with the (rho + Q/2)/9 of its other moments, waves along the axis grow where the rate of
/// the odd moments is near 1, by 3e-4 a step at tau - 1/2 = 7e-5. In space it is that of the part
/// orthogonal to the second moments (lbm/hermite_closure.hpp): with kxxyy = rho/9 waves grow at
/// rest on D3Q19 below nu of about 5e-3, by 1.5e-3 a step at 1e-3, and on D3Q27 flow along the
/// edges between walls does below 1e-3 (tests/lbm/edges_between_walls_are_stable.cpp).
/// The separate rate of the trace is what keeps tau -> 1/2 stable: it damps the acoustic waves that
/// start-up and corners of the wall send out.
template <class Real>
struct CentralMoment {
  Real omega;
  OddShare<Real> odd;

  KOKKOS_FUNCTION explicit CentralMoment(Real shear_rate, Real magic = Real(0.125))
      : omega(shear_rate), odd(shear_rate, magic)
  {
  }
  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real) const { return 1; }

  template <Lattice L, class Site>
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<L, Real> const& in, Moments<L, Real>& out,
                                          Site const& site) const
  {
    if constexpr (L::D == 3)
      close_by_hermite(out);
    else
      close_in_the_plane(out, velocity(out), site);
    Real u2 = 0;
    core::static_for<L::D>([&](auto a)
                               __attribute__((always_inline)) { u2 += site.u[a] * site.u[a]; });
    auto u_in = site.u;
    if constexpr (Site::has_sources) u_in -= (Real(0.5) / (1 + site.rho)) * site.S;
    keep_odd_moments(in, out, u_in, L::D == 2 ? odd.quick(u2) : odd(u2));
  }

  template <Lattice L, class Site>
  KOKKOS_FORCEINLINE_FUNCTION static void close_in_the_plane(Moments<L, Real>& out,
                                                             core::Vec<Real, L::D> const& u,
                                                             Site const& site)
  {
    Moments<L, Real> k = central_second_moments(out, u);
    core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
      constexpr int e = second_order_end<L> + h;
      k.m[e] = Real(rest_moment<L>(L::powers(e))) * out.rho();
      if constexpr (Site::has_sources && L::powers(e).order() == 4) k.m[e] += site.Q / 18;
      out.m[e] = raised<L, e>(out, k, u);
    });
  }
};

}  // namespace velum::lbm
