#pragma once
#include <Kokkos_Core.hpp>

namespace velum::core {

/// What the two lattice directions mean: a plane of unit depth, or the meridional plane of a
/// body of revolution about the line y = 0.
enum class Symmetry { planar, axisymmetric };

/// Length of the ring that a point at distance y from the axis stands for: 2 pi y, or 1 (unit
/// depth).
KOKKOS_INLINE_FUNCTION double ring(Symmetry symmetry, double y)
{
  return symmetry == Symmetry::axisymmetric ? 6.283185307179586 * y : 1.0;
}

}  // namespace velum::core
