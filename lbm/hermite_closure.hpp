#pragma once
#include "lbm/central_shift.hpp"

namespace velum::lbm {

/// Moments of odd order vanish about the fluid's own velocity.
struct EvenOrders {
  KOKKOS_FUNCTION static constexpr bool vanishes(Powers const& e) { return e.order() % 2 == 1; }
};

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
    out.m[i] = shifted<L, i, EvenOrders>(k, u);
  });
}

}  // namespace velum::lbm
