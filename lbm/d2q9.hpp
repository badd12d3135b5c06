#pragma once
#include <Kokkos_Core.hpp>

namespace velum::lbm {

/// The nine-velocity lattice of the plane; opposite directions stand side by side.
/// Qian, d'Humieres & Lallemand, Europhys. Lett. 17 (1992) 479, doi:10.1209/0295-5075/17/6/001.
struct D2Q9 {
  static constexpr int D = 2, Q = 9;
  static constexpr double cs2 = 1.0 / 3;

  KOKKOS_FUNCTION static constexpr int cx(int i)
  {
    constexpr int t[Q] = {0, 1, -1, 0, 0, 1, -1, 1, -1};
    return t[i];
  }
  KOKKOS_FUNCTION static constexpr int cy(int i)
  {
    constexpr int t[Q] = {0, 0, 0, 1, -1, 1, -1, -1, 1};
    return t[i];
  }
  KOKKOS_FUNCTION static constexpr double w(int i)
  {
    return i == 0 ? 4.0 / 9 : i < 5 ? 1.0 / 9 : 1.0 / 36;
  }
  KOKKOS_FUNCTION static constexpr int opposite(int i)
  {
    return i == 0 ? 0 : i % 2 == 1 ? i + 1 : i - 1;
  }
  /// Direction with the second component reversed: the image of i in the axis y = 0.
  KOKKOS_FUNCTION static constexpr int mirrored_in_axis(int i)
  {
    constexpr int t[Q] = {0, 1, 2, 4, 3, 7, 8, 5, 6};
    return t[i];
  }
};

/// Proof at compile time: weights, isotropy up to fourth order, opposites, mirror images.
constexpr bool is_consistent()
{
  auto const near = [](double a, double b) { return a - b < 1e-15 && b - a < 1e-15; };
  double sum = 0, xx = 0, yy = 0, xy = 0, xxxx = 0, xxyy = 0;
  for (int i = 0; i < D2Q9::Q; ++i) {
    double const w = D2Q9::w(i);
    int const x = D2Q9::cx(i), y = D2Q9::cy(i), o = D2Q9::opposite(i),
              m = D2Q9::mirrored_in_axis(i);
    sum += w, xx += w * x * x, yy += w * y * y, xy += w * x * y;
    xxxx += w * x * x * x * x, xxyy += w * x * x * y * y;
    if (D2Q9::cx(o) != -x || D2Q9::cy(o) != -y) return false;
    if (D2Q9::cx(m) != x || D2Q9::cy(m) != -y) return false;
  }
  double const c = D2Q9::cs2;
  return near(sum, 1) && near(xx, c) && near(yy, c) && near(xy, 0) && near(xxxx, 3 * c * c) &&
         near(xxyy, c * c);
}
static_assert(is_consistent());

}  // namespace velum::lbm
