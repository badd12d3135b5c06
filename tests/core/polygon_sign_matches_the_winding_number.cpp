#include "core/obstacle.hpp"
#include "tests/core/sample_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace velum::tests {
namespace {

using namespace core;

/// Turns that the outline makes around p, as the sum of the angles its edges subtend.
double winding_number(std::vector<Vec2> const& corners, Vec2 const& p)
{
  double angle = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Vec2 const a = corners[k] - p, b = corners[(k + 1) % corners.size()] - p;
    angle += std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b));
  }
  return angle / 6.283185307179586;
}

/// A star of seven points, unequal and turned so that no edge is parallel to an axis.
std::vector<Vec2> twisted_star()
{
  std::vector<Vec2> corners;
  for (int k = 0; k < 14; ++k) {
    double const radius = k % 2 == 0 ? 2.0 : 0.8 + 0.05 * k, angle = 0.1 + 0.4487989505128276 * k;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}

TEST(Polygon, sign_matches_the_winding_number_in_both_directions)
{
  auto corners = twisted_star();
  auto const forward = polygon(corners);
  std::reverse(corners.begin(), corners.end());
  auto const backward = polygon(corners);
  for (Vec2 const& p : sample_points({-2.2, -2.2}, {2.2, 2.2}, 20000)) {
    bool const inside = std::abs(winding_number(corners, p)) > 0.5;
    EXPECT_EQ(distance(forward, p) < 0, inside);
    EXPECT_NEAR(distance(forward, p), distance(backward, p), 1e-15);
  }
}

TEST(Polygon, sign_is_right_where_the_ray_runs_through_corners)
{
  auto const stairs = polygon({{0, 0}, {3, 0}, {3, 2}, {2, 1}, {1, 2}, {1, 1}, {0, 1}});
  EXPECT_LT(distance(stairs, {0.5, 0.5}), 0);
  EXPECT_GT(distance(stairs, {-0.5, 1}), 0);  // the ray runs along an edge and through a notch
  EXPECT_LT(distance(stairs, {1.5, 1}), 0);
  EXPECT_GT(distance(stairs, {0.5, 2}), 0);  // the ray touches two tips
  EXPECT_GT(distance(stairs, {2, 1.5}), 0);
}

TEST(Polygon, distance_equals_that_of_a_densely_sampled_outline)
{
  auto const corners = twisted_star();
  auto const star = polygon(corners);
  int const pieces = 2000;
  for (Vec2 const& p : sample_points({-3, -3}, {3, 3}, 100)) {
    double nearest = 1e9, spacing = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      Vec2 const a = corners[k], edge = corners[(k + 1) % corners.size()] - a;
      spacing = std::max(spacing, norm(edge) / pieces);
      for (int s = 0; s <= pieces; ++s)
        nearest = std::min(nearest, norm(p - a - (double(s) / pieces) * edge));
    }
    EXPECT_LE(std::abs(distance(star, p)), nearest + 1e-14);
    EXPECT_GE(std::abs(distance(star, p)), nearest - spacing / 2);
  }
}

}  // namespace
}  // namespace velum::tests
