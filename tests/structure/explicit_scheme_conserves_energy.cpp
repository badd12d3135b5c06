// problem:    clamped disc, no damping, let go from an inflated shape: large free oscillation
// reference:  energy (kinetic + elastic) is constant; symplectic Euler keeps it within O(dt) for
//             all times (Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), IX.8)
// measure:    largest |E - E0| / E0 over 20000 steps, and the mean of the last against the first
//             quarter; halved step
// tolerance:  3 % with 0.1 of the stable step, 0.2 % drift, the error halves with the step
// why:        first order in dt: omega dt = 0.2 in the highest mode, which carries little energy
#include "structure/explicit_step.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/stable_step.hpp"
#include "structure/static_solve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace velum::structure {
namespace {

struct Swing {
  double error, drift;
};

Swing swing(double share_of_stable_step, int steps)
{
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / 20, [](double) { return 0.01; },
                          neo_hookean_rubber(100), 1});
  auto const pressure = uniform_pressure(m, Side::minus, 0.5);
  std::array const loads{pressure_load(m, pressure)};
  static_solve(m, loads);

  auto stepper = explicit_stepper(m, {});
  double const dt = share_of_stable_step * stable_step(m, stepper.mass, m.position);
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
  double const start = elastic_energy(m, m.position);
  double error = 0, first = 0, last = 0;
  for (int n = 0; n < steps; ++n) {
    advance(stepper, m, none, {}, dt, 1, {});
    double const energy = elastic_energy(m, m.position) + kinetic_energy(m, stepper.mass);
    error = std::max(error, std::abs(energy - start) / start);
    if (n < steps / 4) first += energy;
    if (n >= steps - steps / 4) last += energy;
  }
  return {error, std::abs(last - first) / first};
}

TEST(ExplicitScheme, conserves_energy)
{
  auto const coarse = swing(0.1, 20000), fine = swing(0.05, 40000);
  EXPECT_LT(coarse.error, 0.03);
  EXPECT_LT(coarse.drift, 0.002);
  EXPECT_NEAR(fine.error / coarse.error, 0.5, 0.15);
  RecordProperty("largest_error", std::to_string(coarse.error));
  RecordProperty("drift", std::to_string(coarse.drift));
}

}  // namespace
}  // namespace velum::structure
