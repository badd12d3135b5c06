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

}  // namespace

Load pressure_load(Sheet const& s, Eigen::VectorXd const& pressure)
{
  return [&s, &pressure](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    for (int e = 0; e < element_count(s); ++e) {
      auto const& t = s.triangles[static_cast<std::size_t>(e)];
      Eigen::Vector3d const a = node3(x, t[0]), b = node3(x, t[1]), c = node3(x, t[2]);
      double const sixth = pressure[e] / 6;  // twice the area times a third
      Eigen::Vector3d const each = -sixth * (b - a).cross(c - a);
      for (int n : t) force.segment<3>(3 * n) += each;
      if (!tangent) continue;
      // the area vector is a x b + b x c + c x a
      Eigen::Matrix3d const by[3] = {cross_matrix(c - b), cross_matrix(a - c), cross_matrix(b - a)};
      for (int n : t)
        for (int m = 0; m < 3; ++m)
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              if (i != j) tangent->emplace_back(3 * n + i, 3 * t[m] + j, -sixth * by[m](i, j));
    }
  };
}

double swept_volume(Sheet const& s, Eigen::VectorXd const& x)
{
  return volume(s, x) - volume(s, s.reference);
}

}  // namespace velum::structure
