// problem:    free vibration of a strip and of an inflated disc, with steps below and above the
// bound reference:  2 / omega_max from a dense eigenvalue problem M^-1 K measure:    bound over
// exact limit; growth after 3000 steps at 0.99 and at 1.3 times the bound tolerance:  0.75 <= ratio
// <= 1; bounded below, divergence above why:        Gershgorin's circles bound from the safe side;
// on a chain they are tight
#include "core/check.hpp"
#include "structure/explicit_step.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/restrained.hpp"
#include "structure/stable_step.hpp"
#include "structure/static_solve.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace velum::structure {
namespace {

double exact_limit(Membrane const& m)
{
  Triplets entries;
  add_stiffness(m, m.position, entries);
  Eigen::MatrixXd K = restrained(entries, m.fixed);
  auto const mass = lumped_mass(m);
  for (int i = 0; i < K.rows(); ++i)
    for (int j = 0; j < K.cols(); ++j) K(i, j) /= std::sqrt(mass[i / 2] * mass[j / 2]);
  for (int i = 0; i < K.rows(); ++i)
    if (m.fixed[i]) K(i, i) = 0;
  return 2 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues().maxCoeff());
}

TEST(StableStep, is_a_bound_and_tight)
{
  auto disc = flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / 30,
                             [](double) { return 0.01; }, neo_hookean_rubber(100), 1});
  auto const pressure = uniform_pressure(disc, Side::minus, 1);
  std::array const loads{pressure_load(disc, pressure)};
  static_solve(disc, loads);
  auto const strip = flat_membrane({core::Symmetry::planar, 0, 1, 0.05, [](double) { return 0.01; },
                                    neo_hookean_rubber(100), 1});
  for (auto const& m : {disc, strip}) {
    double const ratio = stable_step(m, lumped_mass(m), m.position) / exact_limit(m);
    EXPECT_LE(ratio, 1 + 1e-12);
    EXPECT_GE(ratio, 0.75);
  }
}

TEST(StableStep, separates_bounded_from_growing)
{
  for (double const share : {0.99, 1.3}) {
    auto m = flat_membrane({core::Symmetry::planar, 0, 1, 0.05, [](double) { return 0.01; },
                            neo_hookean_rubber(100), 1});
    for (int i = 3; i < 38; i += 2) m.velocity[i] = 1e-6 * (i % 4 - 2);
    auto stepper = explicit_stepper(m, {});
    double const dt = share * stable_step(m, stepper.mass, m.position);
    Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
    auto run = [&] {
      for (int n = 0; n < 3000; ++n) advance(stepper, m, none, {}, dt, 1, {});
    };
    if (share < 1) {
      run();
      EXPECT_LT(m.velocity.cwiseAbs().maxCoeff(), 1e-4);
    } else {
      bool stopped = false;
      try {
        run();
      } catch (core::Divergence const&) {
        stopped = true;
      }
      EXPECT_TRUE(stopped || m.velocity.cwiseAbs().maxCoeff() > 1);
    }
  }
}

TEST(StableStep, shrinks_with_contact_stiffness)
{
  auto const m = flat_membrane({core::Symmetry::planar, 0, 1, 0.05, [](double) { return 0.01; },
                                neo_hookean_rubber(100), 1});
  auto const mass = lumped_mass(m);
  double const free = stable_step(m, mass, m.position);
  Eigen::VectorXd const contact = 1e6 * mass;  // omega^2 = 1e6 on its own
  double const held = stable_step(m, mass, m.position, {}, contact);
  EXPECT_NEAR(4 / (held * held), 4 / (free * free) + 1e6, 1e-6 * 4 / (held * held));
  EXPECT_EQ(substeps_for(1.0, 0.5, 0.8), 3);
  EXPECT_EQ(substeps_for(0.1, 0.5, 0.8), 1);
}

}  // namespace
}  // namespace velum::structure
