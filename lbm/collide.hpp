#pragma once
#include "lbm/smagorinsky.hpp"

namespace velum::lbm {

/// Collision of one site with sources of mass and momentum, planar or axisymmetric.
///
/// Every moment m with rate k relaxes as  m += k (meq - m) + (1 - k/2) s  towards the equilibrium
/// of the mid-step density and velocity, rho = rho_in + Q/2, rho u = j_in + S/2.
///
/// Axisymmetric (y is the radius): the population that leaves along c carries the weight of the
/// mid-point of its link, y + c_y/2, and arrives with that same weight. Mass and axial momentum so
/// weighted are kept to round-off by
///   Q  = -(j_y,in + j_y,out) / 2y,   S_x = F_x - (Pxy_in + Pxy_out) / 2y,
///   S_y = F_y - ((Pyy_in + Pyy_out)/2 - P_theta) / y,   P_theta = p - 2 mu u_y / y,
/// where the mean of the second moments before and after collision is the lattice's own momentum
/// flux, viscous part included, so no velocity gradient is needed. The trace carries the source
/// 2/3 (1 + a) Q. With a = 1 the bulk viscosity acts on the divergence in three dimensions, as it
/// should, but below nu of about 0.005 the row at the axis is then unstable; with a = 0, stable, it
/// acts on that in the plane, whose error is a pressure rho u_y / 6y. a = y^2 / (y^2 + 4) gives up
/// the correction within two cells of the axis. The equilibrium of the trace has the viscous part
/// 2 mu u_y / y. Splitting of geometric sources after Hajabdollahi &
/// Premnath (arXiv:1806.10241); the link weights, which make it conservative, are velum's own.
///
/// @param f      populations less w before, and after, collision
/// @param inv_y  1 / radius in cells; ignored when planar
/// @param Fx,Fy  force per volume
/// @param smagorinsky_squared  C^2, zero for none
template <bool Axisymmetric, class Real, class Collision>
KOKKOS_FORCEINLINE_FUNCTION void collide(Real (&f)[9], Collision const& collision, Real inv_y,
                                         Real Fx, Real Fy, Real smagorinsky_squared)
{
  Moments<Real> const in = moments(f);
  Moments<Real> out = in;
  Real const third = Real(1) / 3;

  Real n = 1 + in.rho, rho = in.rho, Q = 0, Sx = Fx, Sy = Fy;
  Real ux = (in.jx + Fx / 2) / n, uy = (in.jy + Fy / 2) / n;

  Real shear = collision.shear_rate();
  if (smagorinsky_squared > 0) {
    Real const N_neq = in.N - n * (ux * ux - uy * uy);
    shear = smagorinsky_rate(shear, N_neq, in.Pxy - n * ux * uy, rho, smagorinsky_squared);
  }
  Real const bulk = collision.bulk_rate(shear);
  Real T = 0, N = 0, Pxy = 0;  // means of the values before and after collision
  Real const off_axis = Axisymmetric ? 1 / (1 + 4 * inv_y * inv_y) : Real(1);

  auto const second_moments = [&](Real T_viscous) {
    Real const xx = ux * ux, yy = uy * uy;
    Real const T_eq = 2 * third * rho + n * (xx + yy) + T_viscous;
    Real const s_T = 2 * (1 + off_axis) * third * Q + 2 * (ux * Sx + uy * Sy) - (xx + yy) * Q;
    Real const s_N = 2 * (ux * Sx - uy * Sy) - (xx - yy) * Q;
    Real const s_xy = ux * Sy + uy * Sx - ux * uy * Q;
    T = bulk / 2 * T_eq + (1 - bulk / 2) * (in.T + s_T / 2);
    N = shear / 2 * n * (xx - yy) + (1 - shear / 2) * (in.N + s_N / 2);
    Pxy = shear / 2 * n * ux * uy + (1 - shear / 2) * (in.Pxy + s_xy / 2);
  };

  if constexpr (Axisymmetric) {
    // S_y depends on u_y through the terms linear in u_y / y, which are solved for exactly (they
    // are not small in the row at the axis), and through products of velocities, which are
    // iterated.
    Real const mu = third * (1 / shear - Real(0.5)) * n;
    Real const linear = inv_y * inv_y * ((1 - bulk / 2) * off_axis / 6 * n - (2 + bulk / 2) * mu);
#pragma GCC unroll 3  // a loop in here keeps the loop over the row from being vectorised
    for (int pass = 0; pass < 3; ++pass) {
      Real const u_theta = uy * inv_y;
      Q = -n * u_theta;
      rho = in.rho + Q / 2;
      n = 1 + rho;
      second_moments(2 * mu * u_theta);
      Real const p_theta = third * rho - 2 * mu * u_theta;
      Sx = Fx - Pxy * inv_y;
      Sy = Fy - ((T - N) / 2 - p_theta) * inv_y;
      ux = (in.jx + Sx / 2) / n;
      uy = (in.jy + Sy / 2 - linear * uy / 2) / (n - linear / 2);
    }
    Q = -(in.jy + Sy / 2) * inv_y;
  } else {
    second_moments(0);
  }

  out.rho = in.rho + Q;
  out.jx = in.jx + Sx;
  out.jy = in.jy + Sy;
  out.T = 2 * T - in.T;
  out.N = 2 * N - in.N;
  out.Pxy = 2 * Pxy - in.Pxy;
  collision.higher(in, out, rho, ux, uy, Sx, Sy, Q, shear);
  populations(out, f);
}

}  // namespace velum::lbm
