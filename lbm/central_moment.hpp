#pragma once
#include "lbm/moments.hpp"

namespace velum::lbm {

/// Central moments: shear moments relax at the shear rate, the trace at rate 1, and all third and
/// fourth central moments are set to their equilibrium.
/// Geier, Greiner & Korvink, Phys. Rev. E 73 (2006) 066705, doi:10.1103/PhysRevE.73.066705.
/// The separate rate of the trace is what keeps tau -> 1/2 stable: it damps the acoustic waves that
/// start-up and corners of the wall send out.
template <class Real>
struct CentralMoment {
  Real omega;

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real) const { return 1; }

  /// Central moments about the velocity after collision, u' = j/rho: kxxy = kxyy = 0,
  /// kxxyy = rho/9; raw moments follow by the binomial shift.
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<Real> const&, Moments<Real>& out, Real, Real,
                                          Real, Real, Real, Real, Real) const
  {
    Real const third = Real(1) / 3, n = 1 + out.rho;
    Real const x = out.jx / n, y = out.jy / n;
    Real const xx = x * x, yy = y * y, xy = x * y;
    Real const kxx = (out.T + out.N) / 2 - n * xx;  // less 1/3
    Real const kyy = (out.T - out.N) / 2 - n * yy;  // less 1/3
    Real const kxy = out.Pxy - n * xy;
    out.xxy = 2 * x * kxy + y * (third + kxx) + n * xx * y;
    out.xyy = 2 * y * kxy + x * (third + kyy) + n * x * yy;
    out.xxyy = third * third * out.rho + xx * (third + kyy) + yy * (third + kxx) + 4 * xy * kxy +
               n * xx * yy;
  }
};

}  // namespace velum::lbm
