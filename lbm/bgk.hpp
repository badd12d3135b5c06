#pragma once
#include "lbm/moments.hpp"

namespace velum::lbm {

/// Single relaxation time: every moment of second-order equilibrium relaxed at the same rate.
/// Bhatnagar, Gross & Krook, Phys. Rev. 94 (1954) 511; forcing of Guo, Zheng & Shi,
/// Phys. Rev. E 65 (2002) 046308, doi:10.1103/PhysRevE.65.046308.
/// Loses stability at the small viscosities of a valve: a reference, not a tool.
template <class Real>
struct Bgk {
  Real omega;  // 1 / (3 nu + 1/2)

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real shear) const { return shear; }

  /// Third and fourth moments after collision; u the mid-step velocity, S and Q the sources of
  /// momentum and mass, shear the local rate (it differs from omega where the eddy viscosity acts).
  KOKKOS_FORCEINLINE_FUNCTION void higher(Moments<Real> const& in, Moments<Real>& out, Real rho,
                                          Real ux, Real uy, Real Sx, Real Sy, Real Q,
                                          Real shear) const
  {
    higher_moments_of_second_order(in, out, rho, ux, uy, Sx, Sy, Q, shear, shear);
  }

  /// Relaxes xxy, xyy at the rate odd and xxyy at the rate even towards the second-order
  /// equilibrium; sources enter with the factor 1 - rate/2.
  KOKKOS_FORCEINLINE_FUNCTION static void higher_moments_of_second_order(Moments<Real> const& in,
                                                                         Moments<Real>& out,
                                                                         Real rho, Real ux, Real uy,
                                                                         Real Sx, Real Sy, Real Q,
                                                                         Real odd, Real even)
  {
    Real const third = Real(1) / 3, n = 1 + rho, u2 = ux * ux + uy * uy;
    out.xxy = in.xxy + odd * (third * n * uy - in.xxy) + (1 - odd / 2) * third * Sy;
    out.xyy = in.xyy + odd * (third * n * ux - in.xyy) + (1 - odd / 2) * third * Sx;
    out.xxyy = in.xxyy + even * (third * third * rho + third * n * u2 - in.xxyy) +
               (1 - even / 2) * (third * third * Q + third * (2 * (ux * Sx + uy * Sy) - u2 * Q));
  }
};

}  // namespace velum::lbm
