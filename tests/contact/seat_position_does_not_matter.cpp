// problem:    membrane and seat moved together along the axis by fractions of an element; the seat
//             alone moved outwards by fractions of an element
// reference:  the unmoved problem; forces and deflection must be continuous in the seat's radius
// measure:    seat force and centre deflection
// tolerance:  moved together: 1e-7; moved outwards: from one quarter to the next the deflection
//             changes by its mean trend within 30 %
// why:        translation changes nothing but round-off; contact at nodes sees the seat through its
//             distance only, so no position is preferred beyond the element's own discretisation
#include "tests/contact/pressed_membrane.hpp"
#include "tests/contact/valve_membrane.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::tests {
namespace {

TEST(SeatPosition, along_the_axis_does_not_matter)
{
  auto reference = closed_valve(1e12, false);
  auto const r = press(reference, 100e3, contact::LipPressure::linear, false);
  for (double const cells : {0.25, 0.5, 0.75}) {
    auto moved = closed_valve(1e12, false, 1e-4, cells * 1e-4);
    auto const s = press(moved, 100e3, contact::LipPressure::linear, false);
    EXPECT_NEAR(s.patch.resultant[0], r.patch.resultant[0], 1e-7 * r.patch.resultant[0]);
    EXPECT_NEAR(moved.membrane.position[0] - cells * 1e-4, reference.membrane.position[0], 1e-10);
  }
}

double deflection_with_seat_at(double inner)
{
  auto s = pressed(
      structure::flat_membrane({core::Symmetry::axisymmetric, 0, 8.25e-3, 1e-4,
                                [](double) { return 2e-3; }, structure::neo_hookean_rubber(0.946e6),
                                1140}),
      core::polygon(
          {{-3e-3, inner}, {-1.1e-3, inner}, {-1.1e-3, inner + 0.5e-3}, {-3e-3, inner + 0.5e-3}},
          0.15e-3),
      1e12);
  press(s, 0, contact::LipPressure::linear, false);
  press(s, 100e3, contact::LipPressure::linear, false);
  return s.membrane.position[0];
}

TEST(SeatPosition, across_the_axis_acts_smoothly)
{
  double const first = deflection_with_seat_at(5e-3);
  double const trend = 0.25 * (deflection_with_seat_at(5.1e-3) - first);
  EXPECT_LT(trend, 0);  // a wider seat lets the membrane hang deeper
  double before = first;
  for (double const quarter : {1, 2, 3, 4}) {
    double const now = deflection_with_seat_at(5e-3 + quarter * 0.25e-4);
    EXPECT_NEAR(now - before, trend, 0.3 * std::abs(trend)) << quarter;
    before = now;
  }
}

}  // namespace
}  // namespace velum::tests
