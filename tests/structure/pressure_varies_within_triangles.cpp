// problem:   triangles cut in two by a straight line; a sheet, flat or bent, under a pressure that
//            varies within its triangles
// reference: integral over a triangle of q N_a for q linear: A (2 q_a + q_b + q_c)/12; force of a
//            pressure linear in the place over a flat disc, exact for its polygon: with p = y the
//            moments about the axes are the polygon's second moments, n r^4/24 sin(t) (2 + cos t)
//            with t = 2 pi/n; uniform: the load by one pressure for each triangle
// measure:   difference of both sides
// tolerance: 1e-14, 1e-12
// why:       integrals of products of linear functions are exact: round-off only
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/triangle_part.hpp"

namespace velum::structure {
namespace {

/// q at the corners of a part, linear between its values at the triangle's.
Eigen::Vector4d at_part(TrianglePart const& part, Eigen::Vector3d const& q)
{
  Eigen::Vector4d at = Eigen::Vector4d::Zero();
  for (int k = 0; k < part.count; ++k) at[k] = part.corner[static_cast<std::size_t>(k)].dot(q);
  return at;
}

TEST(TrianglePart, and_the_rest_make_the_whole)
{
  Eigen::Vector3d const q(0.7, -1.3, 2.1);
  Eigen::Vector3d const whole = (q + Eigen::Vector3d::Constant(q.sum())) / 12;
  for (int n = 0; n < 200; ++n) {
    Eigen::Vector3d const level(std::sin(3.0 * n), std::sin(5.0 * n + 1), std::sin(7.0 * n + 2));
    auto const above = part_above(level), below = part_above(-level);
    Eigen::Vector3d const sum =
        integral(above, at_part(above, q)) + integral(below, at_part(below, q));
    EXPECT_NEAR((sum - whole).norm(), 0, 1e-14) << level.transpose();
  }
}

TEST(TrianglePart, has_the_area_that_is_cut_off)
{
  auto const corner = part_above({1, -1, -3});  // cut at 1/2 and 1/4 of two sides
  EXPECT_EQ(corner.count, 3);
  EXPECT_NEAR(integral(corner, Eigen::Vector4d::Ones()).sum(), 1.0 / 8, 1e-15);
  EXPECT_EQ(part_above({-1, -1, 0}).count, 0);
  EXPECT_NEAR(integral(part_above({1, 2, 3}), Eigen::Vector4d::Ones()).sum(), 1, 1e-15);
}

TEST(CornerPressure, that_is_uniform_is_the_load_of_each_triangle)
{
  Sheet s = make_sheet(disc_mesh(graded(0, 1, 4)), 0.1, neo_hookean_rubber(1), 1);
  for (int i = 0; i < s.position.size(); ++i) s.position[i] += 0.05 * std::sin(17.0 * i);
  Eigen::VectorXd p(element_count(s));
  for (int e = 0; e < p.size(); ++e) p[e] = std::cos(3.0 * e);
  CornerPressure const corners = Eigen::Vector3d::Constant(1.0 / 3) * p.transpose();
  Eigen::VectorXd one = Eigen::VectorXd::Zero(s.position.size()), other = one;
  pressure_load(s, p)(s.position, one, nullptr);
  pressure_load(s, corners)(s.position, other, nullptr);
  EXPECT_NEAR((one - other).cwiseAbs().maxCoeff(), 0, 1e-15);
}

TEST(CornerPressure, that_is_linear_has_the_moment_of_the_polygon)
{
  constexpr int rings = 3, n = 6 * rings;
  Sheet const s = make_sheet(disc_mesh(graded(0, 1, rings)), 0.1, neo_hookean_rubber(1), 1);
  CornerPressure p(3, element_count(s));
  for (int e = 0; e < element_count(s); ++e) {
    Eigen::Vector3d y;
    for (int a = 0; a < 3; ++a)
      y[a] = node3(s.reference,
                   s.triangles[static_cast<std::size_t>(e)][static_cast<std::size_t>(a)])[1];
    auto const whole = part_above(Eigen::Vector3d::Ones());
    p.col(e) = integral(whole, at_part(whole, y));
  }
  Eigen::VectorXd force = Eigen::VectorXd::Zero(s.position.size());
  pressure_load(s, p)(s.position, force, nullptr);
  double sum = 0, about_z = 0, about_y = 0;
  for (int a = 0; a < node_count(s); ++a) {
    Eigen::Vector3d const X = node3(s.reference, a);
    sum += force[3 * a];
    about_z += force[3 * a] * X[1];
    about_y += force[3 * a] * X[2];
  }
  double const t = 2 * std::numbers::pi / n;
  EXPECT_NEAR(sum, 0, 1e-12);
  EXPECT_NEAR(about_y, 0, 1e-12);
  EXPECT_NEAR(about_z, -n / 24.0 * std::sin(t) * (2 + std::cos(t)), 1e-12);
}

}  // namespace
}  // namespace velum::structure
