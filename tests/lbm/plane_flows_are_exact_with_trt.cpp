// problem:   plane Couette flow, and plane Poiseuille flow driven by a body force, n cells across,
//            half-way walls, TRT
// reference: the linear profile; the parabola F/(2 nu) y (n - y), y at cell centres
//            (Ginzburg & d'Humieres, Phys. Rev. E 68 (2003) 066614: exact for magic 3/16)
// measure:   largest error of the cell velocities over the largest velocity, at steady state
// tolerance: 1e-10 double
// why:       both are exact solutions of the discrete scheme; what remains is round-off summed over
//            the steps to steady state
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"

namespace velum {
namespace {

double profile_error(int n, double nu, double force, double lid, bool poiseuille)
{
  lbm::Model model{lbm::Collision::trt, nu, 3.0 / 16};
  model.periodic_x = true;
  model.body_force = {force, 0};
  auto flow = tests::make_flow(lbm::make_fluid<double>(4, n, {0, 0}, core::Symmetry::planar, model),
                               tests::no_solids(),
                               [&](lbm::WallHit const& h) { return h.at[1] > n / 2.0 ? -2 : -1; });
  flow.wall_velocity = {lid, 0};
  for (int t = 0; t < int(32 * n * n / nu / 9.87) + 200; ++t) tests::step(flow);
  auto const state = lbm::cell_states(flow.fluid);
  double worst = 0, largest = 0;
  for (int j = 0; j < n; ++j) {
    double const y = j + 0.5;
    double const exact = poiseuille ? force / (2 * nu) * y * (n - y) : lid * y / n;
    worst = std::max(worst, std::abs(state(j, 1).ux - exact));
    largest = std::max(largest, exact);
  }
  return worst / largest;
}

TEST(PlaneFlows, CouetteIsExact)
{
  for (int n : {4, 8, 16}) EXPECT_LT(profile_error(n, 0.1, 0, 0.05, false), 1e-10) << n;
}

TEST(PlaneFlows, PoiseuilleIsExact)
{
  for (int n : {3, 8, 16})
    for (double nu : {0.02, 0.3}) EXPECT_LT(profile_error(n, nu, 1e-6, 0, true), 1e-10) << n;
}

}  // namespace
}  // namespace velum
