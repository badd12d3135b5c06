#include "structure/triangle_part.hpp"

#include <Eigen/LU>

#include <cmath>

namespace velum::structure {

TrianglePart part_above(Eigen::Vector3d const& level)
{
  TrianglePart part;
  for (int a = 0; a < 3; ++a) {
    int const b = (a + 1) % 3;
    bool const here = level[a] > 0, next = level[b] > 0;
    if (here) part.corner[static_cast<std::size_t>(part.count++)] = Eigen::Vector3d::Unit(a);
    if (here == next) continue;
    double const s = level[a] / (level[a] - level[b]);
    part.corner[static_cast<std::size_t>(part.count++)] =
        (1 - s) * Eigen::Vector3d::Unit(a) + s * Eigen::Vector3d::Unit(b);
  }
  return part;
}

Eigen::Vector3d integral(TrianglePart const& part, Eigen::Vector4d const& q)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 1; k + 1 < part.count; ++k) {
    std::array<int, 3> const fan{0, k, k + 1};
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = part.corner[static_cast<std::size_t>(fan[i])];
    double const share = std::abs(corners.determinant());
    // integral of N_i N_j over a triangle: its area / 12, twice that where i = j
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) sum += share * (i == j ? 2 : 1) / 12 * q[fan[i]] * corners.col(j);
  }
  return sum;
}

}  // namespace velum::structure
