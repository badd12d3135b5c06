#pragma once
#include "lbm/lattice/lattice.hpp"

namespace velum::lbm {

/// The nine-velocity lattice of the plane.
/// Qian, d'Humieres & Lallemand, Europhys. Lett. 17 (1992) 479, doi:10.1209/0295-5075/17/6/001.
struct D2Q9 {
  static constexpr int D = 2, Q = 9;

  /// Component a of direction i, to read; c() is the same, to compute with.
  static constexpr int component(int i, int a)
  {
    constexpr int t[Q][D] = {{0, 0}, {1, 0},   {-1, 0}, {0, 1}, {0, -1},
                             {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
    return t[i][a];
  }
  KOKKOS_FUNCTION static constexpr int c(int i, int a)
  {
    constexpr auto x = packed(Q, [](int k) { return component(k, 0); });
    constexpr auto y = packed(Q, [](int k) { return component(k, 1); });
    return int((a == 0 ? x : y) >> (2 * i) & 3) - 1;
  }
  KOKKOS_FUNCTION static constexpr double w(int i)
  {
    return i == 0 ? 4.0 / 9 : i < 5 ? 1.0 / 9 : 1.0 / 36;
  }
  KOKKOS_FUNCTION static constexpr int opposite(int i)
  {
    return i == 0 ? 0 : i % 2 == 1 ? i + 1 : i - 1;
  }
  /// Powers of the independent moments.
  KOKKOS_FUNCTION static constexpr Powers powers(int k)
  {
    constexpr int t[Q][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 2, 0},
                             {1, 1, 0}, {2, 1, 0}, {1, 2, 0}, {2, 2, 0}};
    return {{t[k][0], t[k][1], t[k][2]}};
  }

  KOKKOS_FUNCTION static constexpr int cx(int i) { return c(i, 0); }
  KOKKOS_FUNCTION static constexpr int cy(int i) { return c(i, 1); }
};
static_assert(Lattice<D2Q9> && is_consistent<D2Q9>());

}  // namespace velum::lbm
