#include "core/check.hpp"
#include "core/revolved.hpp"
#include "core/signed_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace velum::tests {
namespace {

using namespace core;

/// Points spread evenly at random over a cube; the same ones at every call.
std::vector<Vec3> points(int count)
{
  std::mt19937_64 generator(20240501);
  std::uniform_real_distribution<double> place(-3, 3);
  std::vector<Vec3> all;
  for (int k = 0; k < count; ++k)
    all.push_back({place(generator), place(generator), place(generator)});
  return all;
}

/// Central difference of the distance.
Vec3 gradient(SignedDistance<3> const& distance, Vec3 const& p)
{
  Vec3 g;
  for (int k = 0; k < 3; ++k) {
    Vec3 step;
    step[k] = 1e-5;
    g[k] = (distance(p + step) - distance(p - step)) / 2e-5;
  }
  return g;
}

/// Problem:   signed distance d of shapes for which it is known exactly.
/// Reference: the foot p - d grad d of every point p lies on the surface, and grad d has length 1
///            (the eikonal equation), off the ridges.
/// Measure:   |d| at the foot, |grad d| - 1, over 2000 random points.
/// Tolerance: 1e-8 and 1e-8; fewer than 2 % of the points may be passed over as ridge points.
/// Why:       a difference over 1e-5 beside curved distances is good to 1e-9.
void expect_exact(SignedDistance<3> const& distance)
{
  int ridges = 0;
  for (Vec3 const& p : points(2000)) {
    Vec3 const g = gradient(distance, p);
    if (std::abs(norm(g) - 1) > 1e-6) {
      ++ridges;
      continue;
    }
    EXPECT_NEAR(distance(p - distance(p) * g), 0, 1e-8) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
  EXPECT_LT(ridges, 40);
}

TEST(SignedDistance, sphere_satisfies_the_eikonal_equation) { expect_exact(sphere({1, 0, -1}, 1)); }
TEST(SignedDistance, revolved_disc_is_a_torus)
{
  auto const torus = revolved(disc({0.3, 1.5}, 0.5));
  for (Vec3 const& p : points(2000))
    EXPECT_NEAR(torus(p), std::hypot(p[0] - 0.3, std::hypot(p[1], p[2]) - 1.5) - 0.5, 1e-14);
}
TEST(SignedDistance, box_satisfies_the_eikonal_equation)
{
  expect_exact(box<3>({-1, -2, 0}, {2, 1, 1.5}));
}
TEST(SignedDistance, oblique_cylinder_satisfies_the_eikonal_equation)
{
  expect_exact(cylinder({-1, -1, 0}, {1, 0.5, 2}, 0.7));
}
TEST(SignedDistance, scaled_and_moved_box_satisfies_the_eikonal_equation)
{
  expect_exact(scaled(box<3>({-1, -1, -1}, {1, 1, 1}), 0.7, {0.5, -0.25, 1}));
}

TEST(SignedDistance, shapes_have_their_textbook_values)
{
  EXPECT_DOUBLE_EQ(sphere({1, 0, 0}, 2)({4, 4, 0}), 3);
  EXPECT_DOUBLE_EQ(sphere({1, 0, 0}, 2)({1, 0, 0}), -2);
  auto const b = box<3>({0, 0, 0}, {2, 4, 6});
  EXPECT_DOUBLE_EQ(b({3, 6, 8}), 3);
  EXPECT_DOUBLE_EQ(b({0.5, 2, 3}), -0.5);
  EXPECT_DOUBLE_EQ(box<2>({0, 0}, {2, 2})({5, 6}), 5);
  auto const rod = cylinder({0, 0, 0}, {0, 0, 10}, 2);
  EXPECT_DOUBLE_EQ(rod({5, 0, 14}), 5);      // from the rim of the end
  EXPECT_DOUBLE_EQ(rod({0, 1, 12}), 2);      // above the end
  EXPECT_DOUBLE_EQ(rod({0, 0, 5}), -2);      // on the axis
  EXPECT_DOUBLE_EQ(rod({1, 0, 9.5}), -0.5);  // under the end
}

TEST(SignedDistance, union_takes_the_nearest_part_and_difference_cuts)
{
  auto const two = unite<3>({sphere({0, 0, 0}, 1), sphere({4, 0, 0}, 1)});
  EXPECT_DOUBLE_EQ(two({3.5, 2, 0}), std::hypot(0.5, 2) - 1);
  auto const pipe =
      subtract(cylinder({0, 0, 0}, {10, 0, 0}, 2), cylinder({-1, 0, 0}, {11, 0, 0}, 1));
  EXPECT_DOUBLE_EQ(pipe({5, 0, 0}), 1);  // fluid in the bore
  EXPECT_DOUBLE_EQ(pipe({5, 1.75, 0}), -0.25);
  EXPECT_EQ(unite<3>({})({1, 2, 3}), std::numeric_limits<double>::infinity());
}

TEST(SignedDistance, distances_scale_with_the_solid)
{
  auto const metres = cylinder({0, 0, 0}, {1, 1, 0}, 0.5);
  auto const cells = scaled(metres, 40, {3, -7, 2});
  for (Vec3 const& p : points(500))
    EXPECT_NEAR(cells(40 * p + Vec3{3, -7, 2}), 40 * metres(p), 1e-11);
}

TEST(SignedDistance, shape_without_size_is_refused)
{
  EXPECT_THROW(sphere({0, 0, 0}, 0), InputError);
  EXPECT_THROW(cylinder({1, 1, 1}, {1, 1, 1}, 1), InputError);
  EXPECT_THROW(cylinder({0, 0, 0}, {1, 1, 1}, -1), InputError);
  EXPECT_THROW(box<3>({0, 0, 0}, {1, 0, 1}), InputError);
  EXPECT_THROW(scaled(sphere({0, 0, 0}, 1), 0), InputError);
}

}  // namespace
}  // namespace velum::tests
