// problem:   Hagen-Poiseuille flow in a pipe of n cells radius, driven by a body force; wall
//            half-way, and off the lattice at two other distances
// reference: u = F/(4 nu) (R^2 - r^2); flow rate pi F R^4/(8 nu)
// measure:   L2 norm over the section (weighted by r) of the velocity error over the mean velocity
// tolerance: order at least 1.9 over n = 8, 16, 32; error below 0.3 % at n = 32
// why:       axisymmetric terms, walls and collision are each second order
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"
#include "tests/support/order.hpp"

namespace velum {
namespace {

double error(lbm::Collision collision, int n, double offset)
{
  double const R = n - offset, nu = 0.1, force = 8 * nu * 0.02 / (R * R) * 8 / n;
  lbm::Model model{collision, nu, 3.0 / 16};
  model.periodic_x = true;
  model.body_force = {force, 0};
  auto flow = tests::make_flow(
      lbm::make_fluid<double>(3, n, {0, 0}, core::Symmetry::axisymmetric, model),
      core::box({-10, R}, {20, 2.0 * n + 10}), [](lbm::WallHit const&) { return -1; });
  for (int t = 0; t < int(2 * R * R / nu); ++t) tests::step(flow);
  auto const state = lbm::cell_states(flow.fluid);
  double e2 = 0, u2 = 0;
  for (int j = 0; j + 0.5 < R; ++j) {
    double const r = j + 0.5, exact = force / (4 * nu) * (R * R - r * r);
    e2 += r * std::pow(state(j, 1).ux - exact, 2);
    u2 += r * exact * exact;
  }
  return std::sqrt(e2 / u2);
}

TEST(Pipe, IsSecondOrderWithEachCollisionAndWallDistance)
{
  for (auto c : {lbm::Collision::bgk, lbm::Collision::trt, lbm::Collision::central_moments})
    for (double offset : {0.0, 0.2, 0.4}) {
      std::vector<double> h, e;
      for (int n : {8, 16, 32}) {
        h.push_back(1.0 / n);
        e.push_back(error(c, n, offset));
      }
      EXPECT_GT(tests::order(h, e), 1.9)
          << int(c) << " " << offset << ": " << e[0] << " " << e[1] << " " << e[2];
      EXPECT_LT(e[2], 3e-3);
    }
}

}  // namespace
}  // namespace velum
