// problem:    a free membrane in a fluid that pushes with F0 - Z v, sub-stepped, beta damping on
// reference:  its momentum changes by the sum of dt (F0 - Z vbar), vbar the returned mean velocity:
//             elastic and damping forces are internal and sum to zero along the axis
// measure:    axial momentum before and after; work on a fixed node; prescribed velocity
// tolerance:  1e-12 of the impulse
// why:        an exact identity of the scheme, only round-off and the direct solver are left
#include "structure/explicit_step.hpp"
#include "structure/membrane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace velum::structure {
namespace {

Membrane stretched()
{
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, 1, 0.1,
                          [](double y) { return 0.1 + 0.1 * y; }, neo_hookean_rubber(3), 1});
  for (int a = 0; a < node_count(m); ++a)
    m.position[2 * a] = 0.3 * std::cos(1.5 * m.reference[2 * a + 1]);
  return m;
}

std::vector<Eigen::Matrix2d> blocks(int nodes, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Eigen::Matrix2d> Z(nodes);
  for (auto& z : Z) {
    Eigen::Matrix2d const root{{number(random), number(random)}, {number(random), number(random)}};
    z = 5 * root * root.transpose();
  }
  return Z;
}

TEST(VelocityImplicitStep, impulse_is_exact)
{
  std::mt19937 random(1);
  auto m = stretched();
  m.fixed.assign(m.fixed.size(), 0);
  m.fixed[1] = 1;
  auto stepper = explicit_stepper(m, {0, 0.1});
  auto const Z = blocks(node_count(m), random);
  Eigen::VectorXd const F0 = Eigen::VectorXd::Random(m.position.size());
  double before = 0, after = 0, impulse = 0, size = 0;
  for (int a = 0; a < node_count(m); ++a) before += stepper.mass[a] * m.velocity[2 * a];
  double const dt = 0.01;
  for (int n = 0; n < 50; ++n) {
    auto const& mean = advance(stepper, m, F0, Z, dt, 3, {});
    for (int a = 0; a < node_count(m); ++a) {
      double const force = F0[2 * a] - (Z[a] * mean.segment<2>(2 * a))[0];
      impulse += dt * force;
      size += dt * std::abs(force);
    }
  }
  for (int a = 0; a < node_count(m); ++a) after += stepper.mass[a] * m.velocity[2 * a];
  EXPECT_NEAR(after - before, impulse, 1e-12 * size);
}

TEST(VelocityImplicitStep, mean_velocity_is_the_displacement_over_the_step)
{
  std::mt19937 random(2);
  auto m = stretched();
  auto stepper = explicit_stepper(m, {0.5, 0.1});
  Eigen::VectorXd const before = m.position, F0 = Eigen::VectorXd::Random(before.size());
  Eigen::VectorXd const mean = advance(stepper, m, F0, blocks(node_count(m), random), 0.02, 4, {});
  EXPECT_LT((m.position - before - 0.02 * mean).norm(), 1e-13);
}

TEST(VelocityImplicitStep, keeps_prescribed_velocities)
{
  std::mt19937 random(3);
  auto m = stretched();
  int const last = 2 * node_count(m) - 2;
  m.velocity[last] = 0.7;
  auto stepper = explicit_stepper(m, {0.5, 0.1});
  Eigen::VectorXd const F0 = Eigen::VectorXd::Random(m.position.size());
  double const before = m.position[last];
  advance(stepper, m, F0, blocks(node_count(m), random), 0.02, 4, {});
  EXPECT_EQ(m.velocity[last], 0.7);
  EXPECT_NEAR(m.position[last], before + 0.014, 1e-15);
  EXPECT_EQ(m.position[1], 0);
}

TEST(VelocityImplicitStep, that_prescribes_every_velocity_by_beta_drags_the_rest)
{
  // beta so large that the strip moves as if rigid along its length: the free nodes must follow
  // the prescribed end, which they feel only through the damping matrix.
  auto m = flat_membrane(
      {core::Symmetry::planar, 0, 1, 0.25, [](double) { return 0.1; }, neo_hookean_rubber(1), 1});
  m.velocity[1] = m.velocity[9] = 0.3;
  auto stepper = explicit_stepper(m, {0, 1e6});
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
  advance(stepper, m, none, {}, 1e-3, 1, {});
  for (int a = 0; a < 5; ++a) EXPECT_NEAR(m.velocity[2 * a + 1], 0.3, 1e-4);
}

}  // namespace
}  // namespace velum::structure
