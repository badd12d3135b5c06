#pragma once
#include "lbm/site.hpp"
#include "lbm/smagorinsky.hpp"

namespace velum::lbm {

/// What acts on a site beside its populations.
template <class Real, int D>
struct Surroundings {
  core::Vec<Real, D> force = {};  // per volume
  Real inv_y = 0;                 // 1 / radius in cells; ignored when planar
  Real smagorinsky_squared = 0;   // C^2, zero for none
};

/// Collision of one site with sources of mass and momentum, planar, in space or axisymmetric.
///
/// Every moment m with rate k relaxes as  m += k (meq - m) + (1 - k/2) s  towards the equilibrium
/// of the mid-step density and velocity, rho = rho_in + Q/2, rho u = j_in + S/2: second moments
/// here, the trace at the rule's bulk rate and the rest at its shear rate, higher ones by the rule.
///
/// Axisymmetric (y is the radius): the population that leaves along c carries the weight of the
/// mid-point of its link, y + c_y/2, and arrives with that same weight. Mass and axial momentum so
/// weighted are kept to round-off by
///   Q  = -(j_y,in + j_y,out) / 2y,   S_x = F_x - (Pxy_in + Pxy_out) / 2y,
///   S_y = F_y - ((Pyy_in + Pyy_out)/2 - P_theta) / y,
/// where the mean of the second moments before and after collision is the lattice's own momentum
/// flux, viscous part included, so no velocity gradient is needed. The trace carries the source
/// 2/3 Q and its equilibrium the viscous part 2 mu u_y / y. The bulk viscosity then acts on the
/// divergence in the plane, -u_y/y in a flow without one in space: the pressure that moves the
/// fluid, p = ((Pxx + Pyy)/2 - rho u^2/2 - mu u_y/y), is rho/3 less a part that is not small at low
/// Mach number (lbm/pressure.hpp). Round the axis it must act as well,
///   P_theta = p - 2 mu u_y / y,   so   S_y = F_y - ((Pyy - Pxx)/2 + rho u^2/2 + 3 mu u_y/y) / y:
/// with P_theta = rho/3 - 2 mu u_y/y a force rho c_s dx u_r/r^2 remains, at any viscosity; with a
/// source of the trace that moves the bulk viscosity to the divergence in space the row at the axis
/// is unstable. Splitting of geometric sources after Hajabdollahi &
/// Premnath (arXiv:1806.10241); the link weights, which make it conservative, and the choice of the
/// pressure are velum's own.
///
/// @tparam Eddy    whether Smagorinsky's model may act; without it the constant is not looked at
/// @tparam Forced  whether a force may act; without it the force is not looked at
/// @param f      populations less w before, and after, collision
template <Lattice L, bool Axisymmetric, bool Eddy, bool Forced = true, class Real, class Rule>
KOKKOS_FORCEINLINE_FUNCTION void collide(Real (&f)[L::Q], Rule const& rule,
                                         Surroundings<Real, L::D> const& around)
{
  constexpr int D = L::D;
  Moments<L, Real> const in = moments<L>(f);
  Moments<L, Real> out;
  Real const third = Real(1) / 3, inv_y = around.inv_y;
  core::Vec<Real, D> F{};
  if constexpr (Forced) F = around.force;

  constexpr bool sources = Forced || Axisymmetric;
  Site<Real, D, sources> s{in.rho(), {}, F, 0, rule.shear_rate()};
  Real n = 1 + s.rho;
  Real const volume = 1 / n;
  core::static_for<D>([&](auto a) __attribute__((always_inline)) {
    s.u[a] = volume * (in.j(a) + F[a] / 2);
  });
  Real tau = 1 / s.shear;
  if constexpr (Eddy) {
    tau = smagorinsky_time(tau, deviator_magnitude(in, n, s.u), volume, around.smagorinsky_squared);
    s.shear = 1 / tau;
  }
  Real const bulk = rule.bulk_rate(s.shear);

  Real mean[L::Q] = {};  // second moments, means of the values before and after collision
  auto const relax = [&]() __attribute__((always_inline))
  {
    core::static_for<D>([&](auto a) __attribute__((always_inline)) {
      core::static_for<a + 1>([&](auto b) __attribute__((always_inline)) {
        constexpr int ab = second_moment<L>(a, b);
        Real const uu = s.u[a] * s.u[b];
        Real unrelaxed = in.m[ab];
        if constexpr (sources) unrelaxed += (s.u[a] * s.S[b] + s.u[b] * s.S[a] - uu * s.Q) / 2;
        mean[ab] = s.shear / 2 * n * uu + (1 - s.shear / 2) * unrelaxed;
      });
    });
  };
  auto const relax_trace = [&](Real T_viscous) __attribute__((always_inline))
  {
    Real in_trace = 0, trace = 0, u2 = 0, uS = 0;
    core::static_for<D>([&](auto a) __attribute__((always_inline)) {
      constexpr int aa = second_moment<L>(a, a);
      in_trace += in.m[aa];
      trace += mean[aa];
      u2 += s.u[a] * s.u[a];
      if constexpr (sources) uS += s.u[a] * s.S[a];
    });
    Real const T_eq = D * third * s.rho + n * u2 + T_viscous;
    if constexpr (sources) in_trace += third * s.Q + uS - u2 * s.Q / 2;
    Real const T = bulk / 2 * T_eq + (1 - bulk / 2) * in_trace;
    Real const share = (Real(1) / D) * (T - trace);
    core::static_for<D>([&](auto a) __attribute__((always_inline)) {
      constexpr int aa = second_moment<L>(a, a);
      mean[aa] += share;
    });
  };

  if constexpr (Axisymmetric) {
    // S_y depends on u_y through the term linear in u_y / y, which is solved for exactly (it is not
    // small in the row at the axis), and through products of velocities, which are iterated; so are
    // the reciprocals, by Newton's method, for divisions are slow.
    constexpr int xx = second_moment<L>(0, 0), yy = second_moment<L>(1, 1),
                  xy = second_moment<L>(0, 1);
    Real const mu = third * (tau - Real(0.5)) * n;
    Real const linear = -3 * mu * inv_y * inv_y;
    Real per_n = volume, per_y = 1 / (n - linear / 2);
    core::static_for<2>([&](auto) __attribute__((always_inline)) {
      Real const u_theta = s.u[1] * inv_y, u2 = s.u[0] * s.u[0] + s.u[1] * s.u[1];
      s.Q = -n * u_theta;
      s.rho = in.rho() + s.Q / 2;
      n = 1 + s.rho;
      relax();
      s.S[0] = F[0] - mean[xy] * inv_y;
      s.S[1] = F[1] - ((mean[yy] - mean[xx] + n * u2) / 2 + 3 * mu * u_theta) * inv_y;
      per_n *= 2 - n * per_n;
      per_y *= 2 - (n - linear / 2) * per_y;
      s.u[0] = per_n * (in.j(0) + s.S[0] / 2);
      s.u[1] = per_y * (in.j(1) + s.S[1] / 2 - linear * s.u[1] / 2);
    });
    s.Q = -(in.j(1) + s.S[1] / 2) * inv_y;
    relax_trace(2 * mu * s.u[1] * inv_y);
  } else {
    relax();
    relax_trace(0);
  }

  out.rho() = in.rho() + s.Q;
  core::static_for<D>([&](auto a) __attribute__((always_inline)) { out.j(a) = in.j(a) + s.S[a]; });
  core::static_for<second_order_end<L> - 1 - D>([&](auto k) __attribute__((always_inline)) {
    out.m[1 + D + k] = 2 * mean[1 + D + k] - in.m[1 + D + k];
  });
  rule.template higher<L>(in, out, s);
  populations(out, f);
}

}  // namespace velum::lbm
