#pragma once
#include <Eigen/Core>

#include <array>

namespace velum::structure {

/// Part of a triangle on one side of a straight cut: up to four corners, in barycentric
/// coordinates, in order.
struct TrianglePart {
  std::array<Eigen::Vector3d, 4> corner;
  int count = 0;  ///< 0: nothing
};

/// Where the linear function with these values at the triangle's corners is above zero.
TrianglePart part_above(Eigen::Vector3d const& level);

/// Integral of q N_a over the part for the triangle's three shape functions N_a, over the whole
/// triangle's area; q linear between its values at the part's corners (in the fan from the first).
/// The unit q of all parts of a triangle gives 1/3 each.
Eigen::Vector3d integral(TrianglePart const& part, Eigen::Vector4d const& q);

}  // namespace velum::structure
