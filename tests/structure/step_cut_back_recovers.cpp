// problem:    a disc at rest is hit by a stiff one-sided stop within one implicit step; and a load
//             that has no equilibrium at all
// reference:  static equilibrium against the stop, which the strong damping has reached by the end;
//             the sentence of the error
// measure:    cut-backs > 0, centre position after the requested time
// tolerance:  2 % of the travel
// why:        what is left of the motion after ten decay times, and the long last sub-steps
#include "core/check.hpp"
#include "structure/implicit_step.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/static_solve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace velum::structure {
namespace {

Membrane disc()
{
  return flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / 20, [](double) { return 0.01; },
                        neo_hookean_rubber(100), 100});
}

/// Nodes beyond x = 0.05 are pushed back.
Load stop(Membrane const& m)
{
  return [&m](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    double const k = 100;
    for (int a = 0; a < node_count(m); ++a) {
      if (x[2 * a] < 0.05) continue;
      force[2 * a] -= k * (x[2 * a] - 0.05);
      if (tangent) tangent->emplace_back(2 * a, 2 * a, -k);
    }
  };
}

ImplicitReport travel(Membrane& m, int steps)
{
  auto const pressure = uniform_pressure(m, Side::minus, 0.5);
  std::vector<Load> const loads{pressure_load(m, pressure), stop(m)};
  auto stepper = implicit_stepper(m, {2, 0.01});
  ImplicitReport total;
  for (int n = 0; n < steps; ++n) {
    auto const r = advance(stepper, m, 30.0 / steps, loads);
    total.steps += r.steps, total.cut_backs += r.cut_backs;
  }
  return total;
}

TEST(StepCutBack, recovers_and_reaches_the_requested_time)
{
  auto whole = disc(), rest = disc();
  auto const report = travel(whole, 1);
  auto const pressure = uniform_pressure(rest, Side::minus, 0.5);
  std::array const loads{pressure_load(rest, pressure), stop(rest)};
  static_solve(rest, loads);
  EXPECT_GT(report.cut_backs, 0);
  EXPECT_GT(report.steps, 1);
  EXPECT_GT(rest.position[0], 0.04);
  EXPECT_NEAR(whole.position[0], rest.position[0], 0.02 * rest.position[0]);
}

TEST(StepCutBack, gives_up_with_a_sentence)
{
  auto m = disc();
  std::vector<Load> const loads{[](auto const&, Eigen::VectorXd& force, Triplets*) {
    force[0] = std::numeric_limits<double>::quiet_NaN();
  }};
  auto stepper = implicit_stepper(m, {});
  stepper.acceleration = Eigen::VectorXd::Zero(m.position.size());
  try {
    advance(stepper, m, 0.1, loads);
    FAIL() << "a force that is no number was accepted";
  } catch (core::Divergence const& error) {
    EXPECT_NE(std::string(error.what()).find("implicit membrane step fails"), std::string::npos);
  }
}

}  // namespace
}  // namespace velum::structure
