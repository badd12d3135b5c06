// problem:    bending disc with a spring on its middle, damped, in a fluid's force F0 - Z v, thrown
//             against a stop: short implicit steps, which share tangents, and the same steps with a
//             tangent of their own each
// reference:  each other; the stop changes the tangent at once
// measure:    place of all nodes after the bounce; tangents found
// tolerance:  1e-8 of the travel; one tangent in three steps
// why:        both solve each step to 1e-9 of the forces, and the damped motion forgets the rest
#include "structure/implicit_step.hpp"
#include "structure/line_bending.hpp"
#include "structure/mass.hpp"
#include "structure/spring.hpp"
#include "structure/stable_step.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace velum::structure {
namespace {

struct Thrown {
  Eigen::VectorXd position;
  int tangents = 0, touching = 0;
};

Thrown thrown(bool keep, int steps)
{
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / 24, [](double) { return 0.1; },
                          neo_hookean_rubber(100), 20});
  auto const bending = line_bending(m, Rim::clamped);
  Eigen::VectorXd const area = nodal_area(m);
  Thrown result;
  std::vector<Load> const loads{
      bending_load(bending), spring_load(m, {1, 2, 1.9, 0.3}),
      [&](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
        if (tangent) ++result.tangents;
        for (int a = 0; a < node_count(m); ++a) {
          double const k = 4e3 * area[a];  // omega dt = 1/2
          if (x[2 * a] > -0.01) continue;
          ++result.touching;
          force[2 * a] -= k * (x[2 * a] + 0.01);
          if (tangent) tangent->emplace_back(2 * a, 2 * a, -k);
        }
      }};
  double const dt = stable_step(m, lumped_mass(m), m.position, loads);
  std::vector<Eigen::Matrix2d> Z;
  for (int a = 0; a < node_count(m); ++a) Z.push_back(area[a] * Eigen::Matrix2d::Identity());
  Eigen::VectorXd F0 = Eigen::VectorXd::Zero(m.position.size());
  for (int a = 0; a < node_count(m); ++a) F0[2 * a] = -4 * area[a];
  auto stepper = implicit_stepper(m, {0.1, 1e-3}, m.reference, std::span(loads).first(1));
  for (int n = 0; n < steps; ++n) {
    if (!keep) stepper.tangent_step = 0;
    auto const r = advance(stepper, m, F0, std::span<Eigen::Matrix2d const>(Z), dt, loads);
    EXPECT_EQ(r.cut_backs, 0);
  }
  result.position = m.position;
  return result;
}

TEST(KeptTangent, gives_the_same_motion)
{
  int const steps = 400;
  auto const kept = thrown(true, steps), own = thrown(false, steps);
  ASSERT_GT(kept.touching, 0);
  double const travel = own.position.segment(0, 1).cwiseAbs().maxCoeff();
  EXPECT_LT((kept.position - own.position).cwiseAbs().maxCoeff(), 1e-8 * travel);
  EXPECT_GE(own.tangents, steps);
  EXPECT_LT(kept.tangents, steps / 3);
}

}  // namespace
}  // namespace velum::structure
