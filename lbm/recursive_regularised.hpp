#pragma once
#include "lbm/hermite_closure.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Recursive regularisation: of the non-equilibrium only the second moments survive a collision,
/// all of them relaxed at the shear rate; the higher ones are rebuilt from them and the velocity
/// (lbm/hermite_closure.hpp). In space it is CentralMoment but for
/// the rate of the trace.
template <class Real>
struct RecursiveRegularised {
  Real omega;

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real shear) const { return shear; }

  template <Lattice L, class Site>
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<L, Real> const&, Moments<L, Real>& out,
                                          Site const&) const
  {
    close_by_hermite(out);
  }
};

}  // namespace velum::lbm
