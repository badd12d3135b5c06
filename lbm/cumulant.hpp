#pragma once
#include "lbm/central_shift.hpp"
#include "lbm/lattice/d3q27.hpp"
#include "lbm/site.hpp"

namespace velum::lbm {

/// Parametrised cumulants (K17) on D3Q27: shear at the shear rate, trace at rate 1, third cumulants
/// at the rates w3, w4, w5 of the shear rate that make diffusion fourth-order accurate, the fourth
/// ones set to the values A and B of the velocity gradients that go with them, fifth and sixth
/// zero. Where a third cumulant is large against limit * rho its rate goes to 1. Geier, Pasquali &
/// Schoenherr, J. Comput. Phys. 348 (2017) 862, doi:10.1016/j.jcp.2017.05.040, eqs. 103 to 115.
template <class Real>
struct Cumulant {
  Real omega;
  Real limit = Real(0.01);

  KOKKOS_FORCEINLINE_FUNCTION Real shear_rate() const { return omega; }
  KOKKOS_FORCEINLINE_FUNCTION Real bulk_rate(Real) const { return 1; }

  KOKKOS_FUNCTION static constexpr bool vanishes(Powers const& e) { return e.order() == 1; }

  /// Of raw moments none vanishes.
  struct Raw {
    KOKKOS_FUNCTION static constexpr bool vanishes(Powers const&) { return false; }
  };

  KOKKOS_FORCEINLINE_FUNCTION Real limited(Real rate, Real value, Real rho) const
  {
    Real const size = value < 0 ? -value : value;
    return rate + (1 - rate) * size / (size + limit * rho);
  }

  template <class L, class Site>
  requires(L::Q == 27) KOKKOS_FORCEINLINE_FUNCTION
      void higher(Moments<L, Real> const& in, Moments<L, Real>& out, Site const& site) const
  {
    Real const w = site.shear, n = 1 + out.rho(), v = 1 / n;

    auto u_in = velocity(in);
    u_in *= Real(-1);
    Moments<L, Real> before = central_second_moments(in, Real(-1) * u_in);
    core::static_for<L::Q>([&](auto k) __attribute__((always_inline)) {
      if constexpr (L::powers(k).order() == 3) before.m[k] = shifted<L, k, Raw>(in, u_in);
    });

    auto const u = velocity(out);
    Moments<L, Real> k = central_second_moments(out, u);
    third(k, before, n, w);

    // velocity gradients from the second moments before collision
    Real const third_part = Real(1) / 3;
    Real const xx = before.m[at<2, 0, 0>] - third_part * in.rho(),
               yy = before.m[at<0, 2, 0>] - third_part * in.rho(),
               zz = before.m[at<0, 0, 2>] - third_part * in.rho();
    Real const trace = xx + yy + zz;
    Real const Dx = -v / 2 * (w * (3 * xx - trace) + trace);
    Real const Dy = Dx + Real(1.5) * w * v * (xx - yy);
    Real const Dz = Dx + Real(1.5) * w * v * (xx - zz);
    Real const w2 = w * w, diffusion = 1 / w - Real(0.5);
    Real const A = (4 + 2 * w - 3 * w2) / (2 - 7 * w + 5 * w2);
    Real const B = (4 + 28 * w - 14 * w2) / (6 - 21 * w + 15 * w2);
    Real const stretch = -2 * third_part * diffusion * A * n;
    Real const shear_part = diffusion * B * w;  // -(1/3)(1/w - 1/2) B rho (Da_b + Db_a)
    fourth(k, n, {stretch * (Dx + Dy), stretch * (Dx + Dz), stretch * (Dy + Dz)},
           {shear_part * before.m[at<0, 1, 1>], shear_part * before.m[at<1, 0, 1>],
            shear_part * before.m[at<1, 1, 0>]});
    fifth_and_sixth(k, n);
    core::static_for<L::Q - second_order_end<L>>([&](auto h) __attribute__((always_inline)) {
      constexpr int e = second_order_end<L> + h;
      out.m[e] = shifted<L, e, Cumulant>(k, u);
    });
  }

 private:
  /// Number of the moment x^a y^b z^c, known to the compiler: looked up while running it would cost
  /// more than all the rest.
  template <int a, int b, int c>
  static constexpr int at = moment_index<D3Q27>({{a, b, c}});
  template <Powers p>
  static constexpr int of = moment_index<D3Q27>(p);

  /// Third cumulants, which are the third central moments.
  template <class L>
  KOKKOS_FORCEINLINE_FUNCTION void third(Moments<L, Real>& k, Moments<L, Real> const& before,
                                         Real n, Real w) const
  {
    Real const w2 = w * w, w3rd = w2 * w;
    Real const rate_sum = 8 * (w - 2) * (1 + 2 * w) / (-8 - 14 * w + 7 * w2);
    Real const rate_difference = 8 * (w - 2) * (4 * w - 7) / (56 - 50 * w + 9 * w2);
    Real const rate_xyz =
        24 * (w - 2) * (3 * w2 - 7 * w - 2) / (48 + 152 * w - 130 * w2 + 29 * w3rd);
    core::static_for<3>([&](auto a) __attribute__((always_inline)) {
      constexpr Powers p1 = unit(a) + unit((a + 1) % 3) + unit((a + 1) % 3);
      constexpr Powers p2 = unit(a) + unit((a + 2) % 3) + unit((a + 2) % 3);
      constexpr int i = moment_index<L>(p1), j = moment_index<L>(p2);
      Real const sum = before.m[i] + before.m[j], difference = before.m[i] - before.m[j];
      Real const s = (1 - limited(rate_sum, sum, n)) * sum;
      Real const d = (1 - limited(rate_difference, difference, n)) * difference;
      k.m[i] = (s + d) / 2;
      k.m[j] = (s - d) / 2;
    });
    constexpr int xyz = moment_index<L>({{1, 1, 1}});
    k.m[xyz] = (1 - limited(rate_xyz, before.m[xyz], n)) * before.m[xyz];
  }

  /// Fourth central moments from the cumulants: kaabb = C + (kaa kbb + 2 kab^2)/rho,
  /// kaabc = C + (kaa kbc + 2 kab kac)/rho.
  template <class L>
  KOKKOS_FORCEINLINE_FUNCTION void fourth(Moments<L, Real>& k, Real n,
                                          core::Vec<Real, 3> const& squares,
                                          core::Vec<Real, 3> const& mixed) const
  {
    Real const v = 1 / n, third = Real(1) / 3, rho = k.rho();
    core::static_for<3>([&](auto m) __attribute__((always_inline)) {
      constexpr int a = m == 2 ? 1 : 0, b = m == 0 ? 1 : 2;  // xy, xz, yz
      constexpr Powers p = unit(a) + unit(a) + unit(b) + unit(b);
      Real const aa = k.m[second_moment<L>(a, a)] - third * rho,  // less rho/3
          bb = k.m[second_moment<L>(b, b)] - third * rho, ab = k.m[second_moment<L>(a, b)];
      k.m[moment_index<L>(p)] =
          squares[m] + third * third * rho + third * (aa + bb) + v * (aa * bb + 2 * ab * ab);
    });
    core::static_for<3>([&](auto a) __attribute__((always_inline)) {
      constexpr int b = (a + 1) % 3, c = (a + 2) % 3;
      constexpr Powers p = unit(a) + unit(a) + unit(b) + unit(c);
      k.m[moment_index<L>(p)] =
          mixed[a] + v * ((k.m[second_moment<L>(a, a)] + third) * k.m[second_moment<L>(b, c)] +
                          2 * k.m[second_moment<L>(a, b)] * k.m[second_moment<L>(a, c)]);
    });
  }

  /// Fifth and sixth central moments whose cumulants vanish.
  template <class L>
  KOKKOS_FORCEINLINE_FUNCTION void fifth_and_sixth(Moments<L, Real>& k, Real n) const
  {
    Real const v = 1 / n, third = Real(1) / 3;
    Real const xyz = k.m[at<1, 1, 1>];
    core::static_for<3>([&](auto a) __attribute__((always_inline)) {  // one of a, two of b and c
      constexpr Powers A = unit(a), B = unit((a + 1) % 3), C = unit((a + 2) % 3);
      k.m[of<A + B + B + C + C>] =
          v * ((k.m[of<C + C>] + third) * k.m[of<A + B + B>] +
               (k.m[of<B + B>] + third) * k.m[of<A + C + C>] + 4 * k.m[of<B + C>] * xyz +
               2 * (k.m[of<A + C>] * k.m[of<B + B + C>] + k.m[of<A + B>] * k.m[of<B + C + C>]));
    });
    Real const xx = k.m[at<2, 0, 0>] + third, yy = k.m[at<0, 2, 0>] + third,
               zz = k.m[at<0, 0, 2>] + third;
    Real const xy = k.m[at<1, 1, 0>], xz = k.m[at<1, 0, 1>], yz = k.m[at<0, 1, 1>];
    Real const ninth = third * third;
    Real const full =
        v * (4 * xyz * xyz + xx * (k.m[at<0, 2, 2>] + ninth) + yy * (k.m[at<2, 0, 2>] + ninth) +
             zz * (k.m[at<2, 2, 0>] + ninth) +
             4 * (yz * k.m[at<2, 1, 1>] + xz * k.m[at<1, 2, 1>] + xy * k.m[at<1, 1, 2>]) +
             2 * (k.m[at<1, 2, 0>] * k.m[at<1, 0, 2>] + k.m[at<2, 1, 0>] * k.m[at<0, 1, 2>] +
                  k.m[at<2, 0, 1>] * k.m[at<0, 2, 1>])) -
        v * v *
            (16 * xy * xz * yz + 4 * (xz * xz * yy + yz * yz * xx + xy * xy * zz) +
             2 * xx * yy * zz);
    k.m[at<2, 2, 2>] = full - third * ninth;
  }
};

}  // namespace velum::lbm
