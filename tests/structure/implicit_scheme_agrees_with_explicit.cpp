// problem:    clamped disc with damping, pressure switched on smoothly: a large, smooth motion
// reference:  the explicit scheme with 1/16 of the stable step
// measure:    centre position at the end; error of three implicit steps against the finest
// tolerance:  0.2 % of the travel between the schemes; implicit order 2 +- 0.3
// why:        the explicit reference errs by O(dt), its dt 1/300 of the ramp; generalised-alpha is
//             second order on smooth motions
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/stable_step.hpp"
#include "tests/support/order.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace velum::structure {
namespace {

constexpr double duration = 1.0;
constexpr Rayleigh damping{2, 0.01};

Membrane disc()
{
  return flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / 16, [](double) { return 0.01; },
                        neo_hookean_rubber(100), 20});
}

void set_pressure(FacePressure& pressure, double t)
{
  double const p = 0.3 * std::pow(std::sin(0.5 * std::numbers::pi * t / duration), 2);
  for (auto& s : pressure) s.p_from = s.p_to = p;
}

double by_implicit(int steps)
{
  auto m = disc();
  auto pressure = uniform_pressure(m, Side::minus, 0);
  std::array const loads{pressure_load(m, pressure)};
  auto stepper = implicit_stepper(m, damping);
  double const dt = duration / steps;
  for (int n = 0; n < steps; ++n) {
    set_pressure(pressure, (n + time_of_loads(stepper)) * dt);
    EXPECT_EQ(advance(stepper, m, dt, loads).cut_backs, 0);
  }
  return m.position[0];
}

double by_explicit()
{
  auto m = disc();
  auto pressure = uniform_pressure(m, Side::minus, 0);
  std::array const loads{pressure_load(m, pressure)};
  auto stepper = explicit_stepper(m, damping);
  int const steps = substeps_for(duration, stable_step(m, stepper.mass, m.position), 1.0 / 16);
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
  for (int n = 0; n < steps; ++n) {
    set_pressure(pressure, (n + 0.5) * duration / steps);
    advance(stepper, m, none, {}, duration / steps, 1, loads);
  }
  return m.position[0];
}

TEST(ImplicitScheme, agrees_with_explicit_and_is_second_order)
{
  double const exact = by_implicit(1280);
  EXPECT_GT(exact, 0.05);
  EXPECT_NEAR(by_explicit(), exact, 0.002 * exact);
  std::vector<double> step, error;
  for (int const n : {40, 80, 160}) {
    step.push_back(duration / n);
    error.push_back(std::abs(by_implicit(n) - exact));
  }
  EXPECT_NEAR(tests::order(step, error), 2, 0.3);
}

}  // namespace
}  // namespace velum::structure
