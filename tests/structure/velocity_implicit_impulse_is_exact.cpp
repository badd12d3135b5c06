// problem:    a free membrane in a fluid that pushes with F0 - Z v, beta damping on: by explicit
//             sub-steps and implicitly, with and without damping of what the step does not resolve;
//             a mass of a tenth of what Z takes up in a step and of a ten thousandth
// reference:  its momentum changes by the sum of dt (F0 - Z vbar), vbar the returned mean velocity:
//             elastic and damping forces are internal and sum to zero along the axis. The
//             generalised-alpha scheme keeps it at the time that its acceleration is ahead of,
//             (1/2 - alpha_f) dt. The force balance at rest in a stiff Z: vbar = Z^-1 F0
// measure:    axial momentum before and after; place over the returned velocity; prescribed
//             velocity; speed that is left of a kick
// tolerance:  1e-12 of the impulse; 1e-9 where Newton ends there; the kick dies down
// why:        an exact identity of the schemes, only round-off, the direct solver and Newton's own
//             tolerance are left
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/mass.hpp"
#include "structure/membrane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace velum::structure {
namespace {

using Blocks = std::vector<Eigen::Matrix2d>;

Membrane stretched()
{
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, 1, 0.1,
                          [](double y) { return 0.1 + 0.1 * y; }, neo_hookean_rubber(3), 1});
  for (int a = 0; a < node_count(m); ++a)
    m.position[2 * a] = 0.3 * std::cos(1.5 * m.reference[2 * a + 1]);
  return m;
}

Blocks blocks(int nodes, std::mt19937& random)
{
  std::uniform_real_distribution<double> number(-1, 1);
  Blocks Z(nodes);
  for (auto& z : Z) {
    Eigen::Matrix2d const root{{number(random), number(random)}, {number(random), number(random)}};
    z = 5 * root * root.transpose();
  }
  return Z;
}

/// One of the two schemes behind one face.
struct Explicit {
  static constexpr double tolerance = 1e-12;
  ExplicitStepper stepper;
  Explicit(Membrane const& m, Rayleigh const& damping) : stepper(explicit_stepper(m, damping)) {}
  Eigen::VectorXd const& step(Membrane& m, Eigen::VectorXd const& F0, Blocks const& Z, double dt)
  {
    return advance(stepper, m, F0, Z, dt, 3, {});
  }
  Eigen::VectorXd balanced_velocity(Membrane const& m, double) const { return m.velocity; }
};

template <int percent>
struct Implicit {
  static constexpr double tolerance = 1e-9;
  ImplicitStepper stepper;
  Implicit(Membrane const& m, Rayleigh const& damping)
      : stepper(implicit_stepper(m, damping, percent / 100.0))
  {
  }
  Eigen::VectorXd const& step(Membrane& m, Eigen::VectorXd const& F0, Blocks const& Z, double dt)
  {
    EXPECT_EQ(advance(stepper, m, F0, std::span<Eigen::Matrix2d const>(Z), dt, {}).cut_backs, 0);
    return stepper.mean;
  }
  Eigen::VectorXd balanced_velocity(Membrane const& m, double dt) const
  {
    double const alpha_f = stepper.rho_inf / (1 + stepper.rho_inf);
    return m.velocity + (0.5 - alpha_f) * dt * stepper.acceleration;
  }
};

template <class Scheme>
struct WallForce : testing::Test {
};
using Schemes = testing::Types<Explicit, Implicit<100>, Implicit<50>, Implicit<0>>;
TYPED_TEST_SUITE(WallForce, Schemes);

TYPED_TEST(WallForce, impulse_is_exact)
{
  std::mt19937 random(1);
  auto m = stretched();
  m.fixed.assign(m.fixed.size(), 0);
  m.fixed[1] = 1;
  TypeParam scheme(m, {0, 0.1});
  auto const Z = blocks(node_count(m), random);
  Eigen::VectorXd const F0 = Eigen::VectorXd::Random(m.position.size()), mass = lumped_mass(m);
  double const dt = 0.01;
  auto const momentum = [&] {
    double sum = 0;
    Eigen::VectorXd const v = scheme.balanced_velocity(m, dt);
    for (int a = 0; a < node_count(m); ++a) sum += mass[a] * v[2 * a];
    return sum;
  };
  scheme.step(m, F0, Z, dt);  // an implicit scheme has its acceleration only now
  double const before = momentum();
  double impulse = 0, size = 0;
  for (int n = 0; n < 50; ++n) {
    auto const& mean = scheme.step(m, F0, Z, dt);
    for (int a = 0; a < node_count(m); ++a) {
      double const force = F0[2 * a] - (Z[a] * mean.template segment<2>(2 * a))[0];
      impulse += dt * force;
      size += dt * std::abs(force);
    }
  }
  EXPECT_NEAR(momentum() - before, impulse, TypeParam::tolerance * size);
}

TYPED_TEST(WallForce, goes_with_the_displacement_over_the_step)
{
  std::mt19937 random(2);
  auto m = stretched();
  TypeParam scheme(m, {0.5, 0.1});
  Eigen::VectorXd const before = m.position, F0 = Eigen::VectorXd::Random(before.size());
  Eigen::VectorXd const mean = scheme.step(m, F0, blocks(node_count(m), random), 0.02);
  EXPECT_LT((m.position - before - 0.02 * mean).norm(), 1e-13);
}

TYPED_TEST(WallForce, leaves_prescribed_velocities)
{
  std::mt19937 random(3);
  auto m = stretched();
  int const last = 2 * node_count(m) - 2;
  TypeParam scheme(m, {0.5, 0.1});
  Eigen::VectorXd const F0 = Eigen::VectorXd::Random(m.position.size());
  double at = m.position[last];
  for (double const velocity : {0.7, -0.2, 0.0}) {
    m.velocity[last] = velocity;
    auto const mean = scheme.step(m, F0, blocks(node_count(m), random), 0.02);
    at += 0.02 * velocity;
    EXPECT_EQ(m.velocity[last], velocity);
    EXPECT_NEAR(mean[last], velocity, 1e-15);
    EXPECT_NEAR(m.position[last], at, 1e-15);
    EXPECT_EQ(m.position[1], 0);
  }
}

TYPED_TEST(WallForce, is_stable_however_large_and_however_light_the_membrane)
{
  for (double const of_mass : {10.0, 1e4}) {
    auto m = stretched();
    m.position = m.reference;
    TypeParam scheme(m, {});
    double const dt = 1e-3;
    Eigen::VectorXd const mass = lumped_mass(m);
    Eigen::VectorXd F0 = Eigen::VectorXd::Zero(m.position.size());
    Blocks Z;
    for (int a = 0; a < node_count(m); ++a)
      Z.push_back(of_mass * mass[a] / dt * Eigen::Matrix2d::Identity());
    for (int i = 0; i < m.velocity.size(); ++i)
      if (!m.fixed[i]) m.velocity[i] = i % 3 == 0 ? 1e-3 : -1e-3;
    for (int n = 0; n < 200; ++n) scheme.step(m, F0, Z, dt);
    // without damping at infinity the sign of the velocity changes from step to step
    double const left = std::pow(std::abs(of_mass / 2 - 1) / (of_mass / 2 + 1), 200);
    EXPECT_LT(m.velocity.norm(), 1e-3 * std::sqrt(m.velocity.size()) * std::max(left, 1e-3));

    // a force that Z alone balances
    m.position = m.reference;
    m.velocity.setZero();
    TypeParam at_rest(m, {});
    for (int a = 1; a + 1 < node_count(m); ++a) F0[2 * a] = 1e-6 * of_mass * mass[a] / dt;
    Eigen::VectorXd mean;
    for (int n = 0; n < 20; ++n) mean = at_rest.step(m, F0, Z, dt);
    for (int a = 1; a + 1 < node_count(m); ++a) EXPECT_NEAR(mean[2 * a], 1e-6, 1e-7);
  }
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
