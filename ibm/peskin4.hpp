#pragma once
#include <Kokkos_Core.hpp>
#include <cmath>

namespace velum::ibm {

/// The regularised delta of width 4 cells, one dimension: with r the distance from a cell in cells,
///   phi = (3 - 2|r| + sqrt(1 + 4|r| - 4r^2)) / 8      |r| <= 1,
///   phi = (5 - 2|r| - sqrt(-7 + 12|r| - 4r^2)) / 8    1 <= |r| <= 2,  zero beyond.
/// Wherever the marker stands in its cell, sum phi = 1, sum r phi = 0 and sum phi^2 = 3/8; even and
/// odd cells share the sum equally, so that a checkerboard is neither seen nor stirred.
/// Peskin, Acta Numerica 11 (2002) 479, section 6, doi:10.1017/S0962492902000077.
struct Peskin4 {
  static constexpr int width = 4;

  KOKKOS_INLINE_FUNCTION static double phi(double r)
  {
    using Kokkos::sqrt;
    using std::sqrt;
    double const a = r < 0 ? -r : r;
    if (a >= 2) return 0;
    if (a <= 1) return (3 - 2 * a + sqrt(1 + 4 * a - 4 * a * a)) / 8;
    double const under_root = -7 + 12 * a - 4 * a * a;
    return (5 - 2 * a - sqrt(under_root > 0 ? under_root : 0)) / 8;
  }
};

}  // namespace velum::ibm
