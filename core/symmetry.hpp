#pragma once
#include <Kokkos_Core.hpp>

namespace velum::core {

/// What the lattice directions mean: a plane of unit depth, the meridional plane of a body of
/// revolution about the line y = 0, or space.
enum class Symmetry { planar, axisymmetric, none };

constexpr int dimensions(Symmetry symmetry) { return symmetry == Symmetry::none ? 3 : 2; }

/// Length of the ring that a point at distance y from the axis stands for: 2 pi y, or 1 (unit
/// depth; in space there is none).
KOKKOS_INLINE_FUNCTION double ring(Symmetry symmetry, double y)
{
  return symmetry == Symmetry::axisymmetric ? 6.283185307179586 * y : 1.0;
}

}  // namespace velum::core
