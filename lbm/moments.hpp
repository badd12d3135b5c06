#pragma once
#include "core/static_for.hpp"
#include "core/vec.hpp"
#include "lbm/lattice/lattice.hpp"

namespace velum::lbm {

/// Raw moments  m_e = sum f c^e  of the deviation f - w of one site, in the lattice's order:
/// density, momentum, second moments, higher ones. All are deviations from the fluid at rest with
/// density 1 (so rho() is the density less one).
template <Lattice L, class Real>
struct Moments {
  Real m[L::Q];

  KOKKOS_FORCEINLINE_FUNCTION Real& rho() { return m[0]; }
  KOKKOS_FORCEINLINE_FUNCTION Real rho() const { return m[0]; }
  KOKKOS_FORCEINLINE_FUNCTION Real& j(int a) { return m[1 + a]; }
  KOKKOS_FORCEINLINE_FUNCTION Real j(int a) const { return m[1 + a]; }
};

/// Moments of one site. Opposite directions are added and subtracted first: even moments need only
/// the sums, odd ones only the differences.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION Moments<L, Real> moments(Real const (&f)[L::Q])
{
  constexpr int pairs = (L::Q - 1) / 2;
  Real sum[pairs], difference[pairs];
  core::static_for<pairs>([&](auto p) __attribute__((always_inline)) {
    sum[p] = f[2 * p + 1] + f[2 * p + 2];
    difference[p] = f[2 * p + 1] - f[2 * p + 2];
  });
  Moments<L, Real> out;
  core::static_for<L::Q>([&](auto k) __attribute__((always_inline)) {
    constexpr Powers e = L::powers(k);
    Real m = k == 0 ? f[0] : Real(0);
    core::static_for<pairs>([&](auto p) __attribute__((always_inline)) {
      constexpr int c = monomial<L>(2 * p + 1, L::powers(k));
      Real const part = e.order() % 2 == 0 ? sum[p] : difference[p];
      if constexpr (c == 1) m += part;
      if constexpr (c == -1) m -= part;
    });
    out.m[k] = m;
  });
  return out;
}

namespace detail {

/// Share of the moment with powers e in the population along c: the product over the directions of
/// 1 - c^2 -> (1, -1) for e = 0, 2 where c = 0, and (c, 1) / 2 for e = 1, 2 elsewhere.
template <class L>
KOKKOS_FUNCTION constexpr int inverse_sign(int i, Powers e)
{
  int sign = 1;
  for (int a = 0; a < L::D; ++a) {
    if (L::c(i, a) == 0) {
      if (e[a] == 1) return 0;
      if (e[a] == 2) sign = -sign;
    } else {
      if (e[a] == 0) return 0;
      if (e[a] == 1) sign *= L::c(i, a);
    }
  }
  return sign;
}

template <class L>
KOKKOS_FUNCTION constexpr int speed_squared(int i)
{
  int sum = 0;
  for (int a = 0; a < L::D; ++a) sum += L::c(i, a) * L::c(i, a);
  return sum;
}

}  // namespace detail

/// The inverse of moments(). Moments that a lattice has not got are zero in it (D3Q19 has no corner
/// velocities, so xyz and all above vanish), which makes one formula serve every lattice.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION void populations(Moments<L, Real> const& in, Real (&f)[L::Q])
{
  Real rest = 0;
  core::static_for<L::Q>([&](auto k) __attribute__((always_inline)) {
    constexpr int s = detail::inverse_sign<L>(0, L::powers(k));
    if constexpr (s == 1) rest += in.m[k];
    if constexpr (s == -1) rest -= in.m[k];
  });
  f[0] = rest;
  core::static_for<(L::Q - 1) / 2>([&](auto p) __attribute__((always_inline)) {
    constexpr int i = 2 * p + 1;
    Real even = 0, odd = 0;
    core::static_for<L::Q>([&](auto k) __attribute__((always_inline)) {
      constexpr int s = detail::inverse_sign<L>(2 * p + 1, L::powers(k));
      constexpr bool is_even = L::powers(k).order() % 2 == 0;
      Real& part = is_even ? even : odd;
      if constexpr (s == 1) part += in.m[k];
      if constexpr (s == -1) part -= in.m[k];
    });
    Real const share = Real(1) / (1 << detail::speed_squared<L>(i));
    f[i] = share * (even + odd);
    f[i + 1] = share * (even - odd);
  });
}

/// Density deviation and momentum alone.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION void density_and_momentum(Real const (&f)[L::Q], Real& rho,
                                                      core::Vec<Real, L::D>& j)
{
  rho = 0;
  j = {};
  for (int i = 0; i < L::Q; ++i) {
    rho += f[i];
    for (int a = 0; a < L::D; ++a) j[a] += Real(L::c(i, a)) * f[i];
  }
}

/// Second-order equilibrium as deviation from w:
///   feq_i - w_i = w_i (rho' + rho (3 c.u + 9/2 (c.u)^2 - 3/2 u^2)),  rho = 1 + rho'.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION Real equilibrium(int i, Real rho, core::Vec<Real, L::D> const& u)
{
  Real cu = 0, u2 = 0;
  for (int a = 0; a < L::D; ++a) {
    cu += Real(L::c(i, a)) * u[a];
    u2 += u[a] * u[a];
  }
  return Real(L::w(i)) * (rho + (1 + rho) * (3 * cu + Real(4.5) * cu * cu - Real(1.5) * u2));
}

}  // namespace velum::lbm
