// problem:    the valve's closed membrane: clamped disc, spring, pressure above and outside the
// seat reference:  law of penalty: penetration p/k; Karush-Kuhn-Tucker conditions of the augmented
//             Lagrangian; vertical equilibrium: spring + pressure = seat + clamp
// measure:    penetration, lambda g, deflection with both laws, forces, at 100 kPa
// tolerance:  slope of penetration over 1/k 1 +- 0.03; penetration of the multipliers below 1e-4
// um;
//             deflection of both 0.1 %; balance 1e-6
// why:        the pressure of the contact hardly depends on k; the multipliers have converged to
//             1e-6 of mu; the balance is exact at a solution, the solver leaves 1e-10
#include "core/check.hpp"
#include "structure/internal_force.hpp"
#include "structure/spring.hpp"
#include "tests/contact/pressed_membrane.hpp"
#include "tests/contact/valve_membrane.hpp"
#include "tests/support/order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace velum::tests {
namespace {

using contact::LipPressure;

TEST(Seat, penetration_of_the_penalty_falls_as_one_over_k)
{
  std::vector<double> compliance, penetration;
  for (double const k : {1e11, 4e11, 1.6e12}) {
    auto s = closed_valve(k, false);
    compliance.push_back(1 / k);
    penetration.push_back(press(s, 100e3, LipPressure::none, false).patch.penetration);
  }
  EXPECT_NEAR(order(compliance, penetration), 1, 0.03);
  EXPECT_LT(penetration.back(), 0.5e-6);
}

TEST(Seat, augmented_lagrangian_is_exact_and_agrees_with_the_penalty)
{
  auto exact = closed_valve(1e11, true), soft = closed_valve(1e12, false);
  auto const a = press(exact, 100e3, LipPressure::linear, true);
  auto const b = press(soft, 100e3, LipPressure::linear, false);
  EXPECT_LT(a.patch.penetration, 1e-10);
  EXPECT_LT(contact::complementarity(exact.seat->contact, exact.seat->markers),
            1e-5);  // Pa m, of 1e6 x 1e-6
  for (std::size_t i = 0; i < exact.seat->markers.X.size(); ++i)
    EXPECT_GE(contact::gap(exact.seat->contact, exact.seat->markers, i), -1e-10);
  double const w0 = exact.membrane.position[0];
  EXPECT_NEAR(soft.membrane.position[0], w0, 0.001 * std::abs(w0));
  EXPECT_NEAR(b.patch.resultant[0], a.patch.resultant[0], 0.01 * a.patch.resultant[0]);
}

TEST(Seat, carries_what_spring_and_pressure_press_and_the_clamp_leaves)
{
  auto s = closed_valve(1e12, false);
  auto const r = press(s, 100e3, LipPressure::none, false);
  auto const& m = s.membrane;
  auto const n = m.position.size();
  double const spring = structure::spring_force(m, spring_of_the_valve,
                                                structure::patch_weights(m, 3e-3), m.position);
  Eigen::VectorXd elastic = Eigen::VectorXd::Zero(n), pressure = elastic;
  structure::add_elastic_force(m, m.position, elastic);
  structure::pressure_load(m, r.pressure)(m.position, pressure, nullptr);
  double of_pressure = 0;
  for (int a = 0; a < node_count(m); ++a) of_pressure += pressure[2 * a];
  double const clamp = -elastic[n - 2] - pressure[n - 2];
  double const scale = r.patch.resultant[0];
  EXPECT_NEAR(spring + of_pressure + r.patch.resultant[0] + clamp, 0, 1e-6 * scale);
  EXPECT_GT(clamp, -0.1 * scale);
  // Pressure acts on what lies inside the outer edge of the land.
  double const edge = m.position[2 * r.patch.last + 1];
  EXPECT_NEAR(of_pressure, -100e3 * std::numbers::pi * edge * edge, 0.05 * scale);
}

TEST(Seat, under_a_linear_lip_carries_half_the_land_less)
{
  auto dry = closed_valve(1e12, false), wet = closed_valve(1e12, false);
  auto const a = press(dry, 100e3, LipPressure::none, false);
  auto const b = press(wet, 100e3, LipPressure::linear, false);
  auto radius = [&](double marker) {
    int const i = static_cast<int>(marker);
    auto const& x = dry.membrane.position;
    return x[2 * i + 1] + (marker - i) * (x[2 * i + 3] - x[2 * i + 1]);
  };
  double const begin = radius(a.patch.begin), end = radius(a.patch.end);
  double const land = std::numbers::pi * (end * end - begin * begin);
  double const less = a.patch.resultant[0] - b.patch.resultant[0];
  EXPECT_NEAR(less, 0.5 * 100e3 * land, 0.2 * 0.5 * 100e3 * land);
}

}  // namespace
}  // namespace velum::tests
