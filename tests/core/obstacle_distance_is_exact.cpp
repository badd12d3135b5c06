#include "core/obstacle.hpp"
#include "tests/core/sample_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace velum::tests {
namespace {

using namespace core;

// A valve seat in outline: a block with a groove, whose mouth is narrower than its bottom.
std::vector<Vec2> const seat = {{0, 0},   {4, 0},   {4, 3},   {2.6, 3},
                                {2.9, 1}, {1.1, 1}, {1.4, 3}, {0, 3}};

/// Problem:   signed distance d and normal n of shapes for which they are known exactly.
/// Reference: the foot p - d n of every point p lies on the surface, and off the ridges the central
///            difference of d is n, of length 1 (the eikonal equation).
/// Measure:   largest |d(p - d n)| and |grad d - n| over 5000 random points.
/// Tolerance: 1e-12 and 1e-5; fewer than 1 % of the points may be passed over as ridge points.
/// Why:       round-off of lengths of order 10; of a difference over 1e-5 beside curved distances.
void expect_exact(Obstacle const& obstacle)
{
  int ridges = 0;
  for (Vec2 const& p : sample_points({-3, -3}, {7, 6}, 5000)) {
    auto const [d, n] = nearest_surface(obstacle, p);
    EXPECT_NEAR(norm(n), 1, 1e-12);
    EXPECT_NEAR(distance(obstacle, p - d * n), 0, 1e-12) << p[0] << ' ' << p[1];

    double const h = 1e-5;
    Vec2 const x{h, 0}, y{0, h};
    Vec2 const difference{(distance(obstacle, p + x) - distance(obstacle, p - x)) / (2 * h),
                          (distance(obstacle, p + y) - distance(obstacle, p - y)) / (2 * h)};
    if (std::abs(norm(difference) - 1) > 1e-6) {
      ++ridges;
      continue;
    }
    EXPECT_NEAR(norm(difference - gradient(obstacle, p)), 0, 1e-5) << p[0] << ' ' << p[1];
  }
  EXPECT_LT(ridges, 50);
}

TEST(Obstacle, box_satisfies_the_eikonal_equation) { expect_exact(box({0, 0}, {4, 3})); }
TEST(Obstacle, rounded_box_satisfies_the_eikonal_equation) { expect_exact(box({0, 0}, {4, 3}, 1)); }
TEST(Obstacle, disc_satisfies_the_eikonal_equation) { expect_exact(disc({1, 2}, 1.5)); }
TEST(Obstacle, concave_polygon_satisfies_the_eikonal_equation) { expect_exact(polygon(seat)); }
TEST(Obstacle, moved_and_scaled_polygon_satisfies_the_eikonal_equation)
{
  expect_exact(transformed(polygon(seat), 0.7, {0.5, -0.25}));
}

TEST(Obstacle, box_has_its_textbook_values)
{
  auto const b = box({-1, -2}, {3, 2});
  EXPECT_DOUBLE_EQ(distance(b, {5, 0}), 2);
  EXPECT_DOUBLE_EQ(distance(b, {6, 6}), 5);
  EXPECT_DOUBLE_EQ(distance(b, {1, 1.5}), -0.5);
  EXPECT_DOUBLE_EQ(distance(b, {3, 1}), 0);
  EXPECT_DOUBLE_EQ(gradient(b, {3, 1})[0], 1);
  EXPECT_DOUBLE_EQ(gradient(b, {6, 6})[1], 0.8);
}

TEST(Obstacle, four_corners_make_the_same_solid_as_a_box)
{
  auto const b = box({0, 0}, {4, 3}, 0.5);
  auto const clockwise = polygon({{0, 0}, {0, 3}, {4, 3}, {4, 0}}, 0.5);
  auto const counter_clockwise = polygon({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0.5);
  for (Vec2 const& p : sample_points({-3, -3}, {7, 6}, 2000)) {
    EXPECT_NEAR(distance(clockwise, p), distance(b, p), 1e-13);
    EXPECT_NEAR(distance(counter_clockwise, p), distance(b, p), 1e-13);
  }
}

TEST(Obstacle, normal_on_the_surface_itself_is_that_of_the_edge)
{
  auto const p = polygon(seat);
  EXPECT_DOUBLE_EQ(gradient(p, {0.5, 3})[1], 1);
  EXPECT_DOUBLE_EQ(gradient(p, {2, 1})[1], 1);
  EXPECT_DOUBLE_EQ(gradient(p, {2, 0})[1], -1);
  EXPECT_DOUBLE_EQ(gradient(p, {4, 1.5})[0], 1);
}

TEST(Obstacle, union_takes_the_nearest_part_and_difference_cuts)
{
  auto const two = unite({disc({0, 0}, 1), disc({4, 0}, 1)});
  EXPECT_DOUBLE_EQ(distance(two, {3.5, 2}), std::hypot(0.5, 2) - 1);
  EXPECT_DOUBLE_EQ(gradient(two, {1.5, 0})[0], 1);
  EXPECT_DOUBLE_EQ(gradient(two, {2.5, 0})[0], -1);

  auto const pipe = subtract(box({0, -2}, {10, 2}), box({-1, -1}, {11, 1}));
  EXPECT_DOUBLE_EQ(distance(pipe, {5, 0}), 1);  // fluid in the bore
  EXPECT_DOUBLE_EQ(distance(pipe, {5, 1.75}), -0.25);
  EXPECT_DOUBLE_EQ(gradient(pipe, {5, 0.5})[1], -1);  // from the wall towards the axis
}

TEST(Obstacle, empty_obstacle_is_infinitely_far)
{
  double const infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(distance(Obstacle{}, {1, 2}), infinity);
  EXPECT_EQ(distance(unite({}), {1, 2}), infinity);
  EXPECT_EQ(distance(subtract({}, disc({0, 0}, 1)), {3, 0}), infinity);
  EXPECT_DOUBLE_EQ(distance(subtract(disc({0, 0}, 1), {}), {3, 0}), 2);
}

TEST(Obstacle, distances_scale_with_the_obstacle)
{
  auto const metres = polygon(seat, 0.1);
  auto const cells = transformed(metres, 40, {3, -7});
  for (Vec2 const& p : sample_points({-3, -3}, {7, 6}, 500)) {
    EXPECT_NEAR(distance(cells, 40 * p + Vec2{3, -7}), 40 * distance(metres, p), 1e-11);
  }
}

}  // namespace
}  // namespace velum::tests
