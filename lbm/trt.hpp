#pragma once
#include "lbm/second_order.hpp"

namespace velum::lbm {

/// Two relaxation times: even moments at the shear rate, odd ones so that
///   magic = (1/shear - 1/2)(1/odd - 1/2)
/// is constant. 3/16 puts the wall of a plane Poiseuille flow exactly half-way, 1/8 gives its exact
/// flux in gaps of any number of cells.
/// Ginzburg, Verhaeghe & d'Humieres, Commun. Comput. Phys. 3 (2008) 427.
template <class Real>
struct Trt {
  Real omega;
  Real magic;

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real shear) const { return shear; }

  template <Lattice L, class Site>
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<L, Real> const& in, Moments<L, Real>& out,
                                          Site const& site) const
  {
    Real const odd = 1 / (magic / (1 / site.shear - Real(0.5)) + Real(0.5));
    relax_higher(in, out, site, odd, site.shear);
  }
};

}  // namespace velum::lbm
