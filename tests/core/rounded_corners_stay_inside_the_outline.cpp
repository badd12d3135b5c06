#include "core/check.hpp"
#include "core/obstacle.hpp"
#include "tests/core/sample_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace velum::tests {
namespace {

using namespace core;

// An L: five convex corners and a concave one, at (2, 1).
std::vector<Vec2> const angle_iron = {{0, 0}, {5, 0}, {5, 1}, {2, 1}, {2, 4}, {0, 4}};
double const radius = 0.25;

TEST(RoundedPolygon, keeps_its_straight_parts_and_loses_its_convex_corners)
{
  auto const rounded = polygon(angle_iron, radius);
  EXPECT_NEAR(distance(rounded, {1, 0}), 0, 1e-15);
  EXPECT_NEAR(distance(rounded, {3.5, 1}), 0, 1e-15);
  EXPECT_NEAR(distance(rounded, {2, 2}), 0, 1e-15);
  EXPECT_NEAR(distance(rounded, {0, 3}), 0, 1e-15);
  double const cut = radius * (std::sqrt(2.0) - 1);  // from a square corner to its arc
  EXPECT_NEAR(distance(rounded, {0, 0}), cut, 1e-15);
  EXPECT_NEAR(distance(rounded, {5, 1}), cut, 1e-15);
  EXPECT_NEAR(distance(rounded, {2, 1}), 0, 1e-15);  // concave: sharp as before
}

TEST(RoundedPolygon, is_a_part_of_the_sharp_one_and_everywhere_within_the_cut)
{
  auto const sharp = polygon(angle_iron), rounded = polygon(angle_iron, radius);
  double const cut = radius * (std::sqrt(2.0) - 1);
  for (Vec2 const& p : sample_points({-1, -1}, {6, 5}, 5000)) {
    double const loss = distance(rounded, p) - distance(sharp, p);
    EXPECT_GE(loss, -1e-14);
    if (distance(sharp, p) > 0) {
      EXPECT_LE(loss, cut + 1e-14);
    }
  }
}

TEST(RoundedPolygon, of_an_acute_wedge_has_its_arc_on_the_bisector)
{
  // A wedge of half angle 30 degrees: the arc's centre lies radius / sin 30 from the tip.
  double const width = std::tan(0.5235987755982988) * 4;
  auto const wedge = polygon({{0, 0}, {4, -width}, {4, width}}, radius);
  EXPECT_NEAR(distance(wedge, {radius, 0}), 0, 1e-15);
  EXPECT_NEAR(distance(wedge, {0, 0}), radius, 1e-15);
}

TEST(RoundedPolygon, refuses_a_radius_that_does_not_fit)
{
  EXPECT_THROW(polygon(angle_iron, 0.51), InputError);  // thicker than half the leg
  EXPECT_NO_THROW(polygon(angle_iron, 0.49));
  EXPECT_THROW(polygon(angle_iron, 5), InputError);
  // Two rooms joined by a neck of width 0.4: the neck goes before the rooms do.
  std::vector<Vec2> const dumb_bell = {{0, 0}, {2, 0}, {2, 0.8}, {4, 0.8}, {4, 0}, {6, 0},
                                       {6, 2}, {4, 2}, {4, 1.2}, {2, 1.2}, {2, 2}, {0, 2}};
  EXPECT_NO_THROW(polygon(dumb_bell, 0.19));
  EXPECT_THROW(polygon(dumb_bell, 0.21), InputError);
  // A square notch that leaves a throat of 0.4; its moved edges meet sqrt(2) radii below its tip.
  std::vector<Vec2> const notch = {{0, 0}, {4, 0}, {4, 2}, {3.6, 2}, {2, 0.4}, {0.4, 2}, {0, 2}};
  EXPECT_NO_THROW(polygon(notch, 0.16));
  EXPECT_THROW(polygon(notch, 0.17), InputError);
}

TEST(Obstacle, refuses_shapes_that_are_none)
{
  double const nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(box({1, 0}, {0, 1}), InputError);
  EXPECT_THROW(box({0, 0}, {nan, 1}), InputError);
  EXPECT_THROW(box({0, 0}, {1, 2}, 0.6), InputError);
  EXPECT_NO_THROW(box({0, 0}, {1, 2}, 0.5));
  EXPECT_THROW(disc({0, 0}, 0), InputError);
  EXPECT_THROW(polygon({{0, 0}, {1, 0}}), InputError);
  EXPECT_THROW(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 0}}), InputError);          // closed twice
  EXPECT_THROW(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), InputError);          // crosses itself
  EXPECT_THROW(polygon({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), InputError);          // folds back
  EXPECT_THROW(polygon({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), InputError);  // touches itself
  EXPECT_THROW(polygon({{0, 0}, {1, 0}, {0, nan}}), InputError);
  EXPECT_THROW(transformed(disc({0, 0}, 1), -1, {0, 0}), InputError);
}

}  // namespace
}  // namespace velum::tests
