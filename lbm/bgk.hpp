#pragma once
#include "lbm/second_order.hpp"

namespace velum::lbm {

/// Single relaxation time: every moment of second-order equilibrium relaxed at the same rate.
/// Bhatnagar, Gross & Krook, Phys. Rev. 94 (1954) 511.
/// Loses stability at the small viscosities of a valve: a reference, not a tool.
template <class Real>
struct Bgk {
  Real omega;  // 1 / (3 nu + 1/2)

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real shear) const { return shear; }

  template <Lattice L, class Site>
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<L, Real> const& in, Moments<L, Real>& out,
                                          Site const& site) const
  {
    relax_higher(in, out, site, site.shear, site.shear);
  }
};

}  // namespace velum::lbm
