#pragma once
#include "lbm/d2q9.hpp"

namespace velum::lbm {

/// Raw moments of the deviation f - w of one site: density, momentum, second moments as trace
/// and deviator, and the third and fourth moments of D2Q9.
///   rho = sum f, j = sum c f, T = Pxx + Pyy, N = Pxx - Pyy, Pxy, xxy = sum cx^2 cy f, ...
/// All are deviations from the fluid at rest with density 1 (so rho here is the density less one).
template <class Real>
struct Moments {
  Real rho, jx, jy, T, N, Pxy, xxy, xyy, xxyy;
};

template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Moments<Real> moments(Real const (&f)[9])
{
  Real const sx = f[1] + f[2], sy = f[3] + f[4];
  Real const p = f[5] + f[6], m = f[7] + f[8];
  Real const dp = f[5] - f[6], dm = f[7] - f[8];
  Real const d = p + m;
  return {f[0] + sx + sy + d,
          f[1] - f[2] + dp + dm,
          f[3] - f[4] + dp - dm,
          sx + sy + 2 * d,
          sx - sy,
          p - m,
          dp - dm,
          dp + dm,
          d};
}

template <class Real>
KOKKOS_FORCEINLINE_FUNCTION void populations(Moments<Real> const& m, Real (&f)[9])
{
  Real const Pxx = (m.T + m.N) / 2, Pyy = (m.T - m.N) / 2;
  f[0] = m.rho - m.T + m.xxyy;
  f[1] = (Pxx - m.xxyy + m.jx - m.xyy) / 2;
  f[2] = (Pxx - m.xxyy - m.jx + m.xyy) / 2;
  f[3] = (Pyy - m.xxyy + m.jy - m.xxy) / 2;
  f[4] = (Pyy - m.xxyy - m.jy + m.xxy) / 2;
  f[5] = (m.xxyy + m.Pxy + m.xxy + m.xyy) / 4;
  f[6] = (m.xxyy + m.Pxy - m.xxy - m.xyy) / 4;
  f[7] = (m.xxyy - m.Pxy - m.xxy + m.xyy) / 4;
  f[8] = (m.xxyy - m.Pxy + m.xxy - m.xyy) / 4;
}

/// Density deviation and momentum alone.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION void density_and_momentum(Real const (&f)[9], Real& rho, Real& jx,
                                                      Real& jy)
{
  rho = f[0] + f[1] + f[2] + f[3] + f[4] + f[5] + f[6] + f[7] + f[8];
  jx = f[1] - f[2] + f[5] - f[6] + f[7] - f[8];
  jy = f[3] - f[4] + f[5] - f[6] - f[7] + f[8];
}

/// Second-order equilibrium as deviation from w:
///   feq_i - w_i = w_i (rho' + rho (3 c.u + 9/2 (c.u)^2 - 3/2 u^2)),  rho = 1 + rho'.
template <class Real>
KOKKOS_FORCEINLINE_FUNCTION Real equilibrium(int i, Real rho, Real ux, Real uy)
{
  Real const cu = D2Q9::cx(i) * ux + D2Q9::cy(i) * uy;
  return Real(D2Q9::w(i)) *
         (rho + (1 + rho) * (3 * cu + Real(4.5) * cu * cu - Real(1.5) * (ux * ux + uy * uy)));
}

}  // namespace velum::lbm
