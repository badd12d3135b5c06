#pragma once
#include "lbm/central_shift.hpp"

namespace velum::lbm {

/// Moments of odd order vanish about the fluid's own velocity.
struct EvenOrders {
  KOKKOS_FUNCTION static constexpr bool vanishes(Powers const& e) { return e.order() % 2 == 1; }
};

/// The axis whose power in e is p, of several the first at or after `from`.
KOKKOS_FUNCTION constexpr int axis_of_power(Powers const& e, int p, int from = 0)
{
  int a = from;
  while (a < 2 && e[a] != p) ++a;
  return a;
}

/// Raw moment number E from its central moment k_E where central moments of odd order vanish: the
/// binomial shift with second moments in place of what they sum up,
///   m_abb = u_a m_bb + 2 u_b k_ab,   m_xyz = u_x m_yz + u_y k_xz + u_z k_xy,
///   m_aabb = k_aabb + m_aa u_b^2 + k_bb u_a^2 + 4 u_a u_b k_ab,
///   m_aabc = k_aabc + m_aa u_b u_c + k_bc u_a^2 + 2 u_a (u_b k_ac + u_c k_ab),
/// half the work of shifted(), which does those above.
/// @param raw  second moments;  @param k  second moments, and number E
template <Lattice L, int E, class Real>
KOKKOS_FORCEINLINE_FUNCTION Real raised(Moments<L, Real> const& raw, Moments<L, Real> const& k,
                                        core::Vec<Real, L::D> const& u)
{
  constexpr Powers e = L::powers(E);
  Real const third = Real(1) / 3;  // of the fluid at rest
  if constexpr (e.order() == 3 && e[0] == 1 && e[1] == 1 && e[2] == 1) {
    return u[0] * raw.m[second_moment<L>(2, 1)] + u[1] * k.m[second_moment<L>(2, 0)] +
           u[2] * k.m[second_moment<L>(1, 0)];
  } else if constexpr (e.order() == 3) {
    constexpr int a = axis_of_power(e, 1), b = axis_of_power(e, 2);
    constexpr int bb = second_moment<L>(b, b);
    constexpr int ab = a > b ? second_moment<L>(a, b) : second_moment<L>(b, a);
    return u[a] * (raw.m[bb] + third) + 2 * u[b] * k.m[ab];
  } else if constexpr (e.order() == 4 && (e[0] == 1 || e[1] == 1 || e[2] == 1)) {
    constexpr int a = axis_of_power(e, 2), b = axis_of_power(e, 1), c = axis_of_power(e, 1, b + 1);
    constexpr int aa = second_moment<L>(a, a), bc = second_moment<L>(c, b);
    constexpr int ab = a > b ? second_moment<L>(a, b) : second_moment<L>(b, a);
    constexpr int ac = a > c ? second_moment<L>(a, c) : second_moment<L>(c, a);
    return k.m[E] + (raw.m[aa] + third) * (u[b] * u[c]) + k.m[bc] * (u[a] * u[a]) +
           2 * u[a] * (u[b] * k.m[ac] + u[c] * k.m[ab]);
  } else if constexpr (e.order() == 4) {
    constexpr int a = axis_of_power(e, 2), b = axis_of_power(e, 2, a + 1);
    constexpr int aa = second_moment<L>(a, a), bb = second_moment<L>(b, b),
                  ab = second_moment<L>(b, a);
    return k.m[E] + (raw.m[aa] + third) * (u[b] * u[b]) + (k.m[bb] + third) * (u[a] * u[a]) +
           4 * k.m[ab] * (u[a] * u[b]);
  } else {
    return shifted<L, E, EvenOrders>(k, u);
  }
}

/// Sets all moments above the second from density, momentum and second moments: Hermite moments of
/// third and higher order about the fluid's own velocity vanish. Central moments are then, third
/// and fifth, zero,
///   kxxyy - rho/9 = (k'xx + k'yy)/3,  kxxyz = kyz/3,  kxxyyzz - rho/27 = (k'xx + k'yy + k'zz)/9,
/// k' less rho/3, and the raw ones follow by the binomial shift. On D3Q19, where the Hermite
/// polynomials of the fourth order are not orthogonal to the second, kxxyy less k'zz/6.
/// Malaspinas, arXiv:1505.06900 (2015), whose recursion this shift is; Coreixas et al., Phys. Rev.
/// E 96 (2017) 033306, doi:10.1103/PhysRevE.96.033306.
template <Lattice L, class Real>
KOKKOS_FORCEINLINE_FUNCTION void close_by_hermite(Moments<L, Real>& out)
{
  auto const u = velocity(out);
  Moments<L, Real> k = central_second_moments(out, u);
  Real const third = Real(1) / 3, rho = out.rho();
  core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
    constexpr int i = second_order_end<L> + h;
    constexpr Powers e = L::powers(second_order_end<L> + h);
    constexpr double rest = rest_moment<L>(e);
    Real value = Real(rest) * rho;
    // the pair of powers of each square (xx of xxyz leaves yz; each square of xxyy the other)
    core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
      core::static_for<a + 1>([&](auto b) __attribute__((always_inline)) {
        constexpr Powers full = L::powers(second_order_end<L> + h), pair = unit(a) + unit(b);
        constexpr bool leaves_squares = is_part(pair, full) && (full[0] - pair[0]) % 2 == 0 &&
                                        (full[1] - pair[1]) % 2 == 0 &&
                                        (full[2] - pair[2]) % 2 == 0;
        if constexpr (full.order() % 2 == 0 && leaves_squares) {
          constexpr int ab = second_moment<L>(a, b);
          Real const share = full.order() == 4 ? third : third * third;
          value += share * (k.m[ab] - (a == b ? third * rho : Real(0)));
        }
      });
    });
    if constexpr (L::Q == 19)
      core::static_for<L::D>([&](auto a) __attribute__((always_inline)) {
        constexpr int aa = second_moment<L>(a, a);
        constexpr Powers full = L::powers(second_order_end<L> + h);
        if constexpr (full.order() == 4 && full[a] == 0)
          value -= Real(1) / 6 * (k.m[aa] - third * rho);
      });
    k.m[i] = value;
    out.m[i] = raised<L, i>(out, k, u);
  });
}

}  // namespace velum::lbm
