#include "structure/sheet_pressure.hpp"

#include <Eigen/Geometry>

namespace velum::structure {
namespace {

/// The matrix [a] with [a] b = a x b.
Eigen::Matrix3d cross_matrix(Eigen::Vector3d const& a)
{
  Eigen::Matrix3d m;
  m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return m;
}

double volume(Sheet const& s, Eigen::VectorXd const& x)
{
  double sum = 0;
  for (auto const& t : s.triangles)
    sum += node3(x, t[0]).dot(node3(x, t[1]).cross(node3(x, t[2]))) / 6;
  return sum;
}

/// Force -w n A on each corner, w its share of the pressure.
void add_pressure(Triangle const& t, Eigen::Vector3d const& share, Eigen::VectorXd const& x,
                  Eigen::VectorXd& force, Triplets* tangent)
{
  Eigen::Vector3d const a = node3(x, t[0]), b = node3(x, t[1]), c = node3(x, t[2]);
  Eigen::Vector3d const area = (b - a).cross(c - a) / 2;
  for (int n = 0; n < 3; ++n) force.segment<3>(3 * t[n]) -= share[n] * area;
  if (!tangent) return;
  // twice the area vector is a x b + b x c + c x a
  Eigen::Matrix3d const by[3] = {cross_matrix(c - b), cross_matrix(a - c), cross_matrix(b - a)};
  for (int n = 0; n < 3; ++n)
    for (int m = 0; m < 3; ++m)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (i != j)
            tangent->emplace_back(3 * t[n] + i, 3 * t[m] + j, -share[n] / 2 * by[m](i, j));
}

}  // namespace

Load pressure_load(Sheet const& s, Eigen::VectorXd const& pressure)
{
  return [&s, &pressure](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    for (int e = 0; e < element_count(s); ++e)
      add_pressure(s.triangles[static_cast<std::size_t>(e)],
                   Eigen::Vector3d::Constant(pressure[e] / 3), x, force, tangent);
  };
}

Load pressure_load(Sheet const& s, CornerPressure const& pressure)
{
  return [&s, &pressure](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    for (int e = 0; e < element_count(s); ++e)
      add_pressure(s.triangles[static_cast<std::size_t>(e)], pressure.col(e), x, force, tangent);
  };
}

double swept_volume(Sheet const& s, Eigen::VectorXd const& x)
{
  return volume(s, x) - volume(s, s.reference);
}

}  // namespace velum::structure
