// problem:   a thick plate, clamped at its rim, pressed from below against a stiff plane
// reference: balance: what the stop carries is what the pressure pushes with less what the rim
//            carries, found as the residual at the clamped nodes
// measure:   force of the stop over that; depth by which the face passes the plane
// tolerance: 1e-9; the depth below 1e-3 of the thickness and the face there everywhere under it
// why:       statics: all forces on all nodes add up to zero but for the solver's residual; the
//            depth is pressure over stiffness, 3e-4 of the thickness here
#include "structure/lift_stop.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "structure/internal_force.hpp"
#include "structure/line_bending.hpp"
#include "structure/pressure_load.hpp"
#include "structure/static_solve.hpp"

namespace velum::structure {
namespace {

TEST(LiftStop, carries_what_pressure_pushes_beyond_the_rim)
{
  constexpr double mu = 1e6, a = 8e-3, H = 1e-3, p = 50e3;
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, a, a / 40, [](double) { return H; },
                          neo_hookean_rubber(mu), 1100});
  auto const bending = line_bending(m, Rim::clamped);
  LiftStop const stop{H / 2 + 0.2e-3, 0.8 * a, std::make_shared<double>(p / (3e-4 * H))};
  auto const pressure = uniform_pressure(m, Side::minus, p);
  std::array const loads{pressure_load(m, pressure), bending_load(bending), stop_load(m, stop)};
  static_solve(m, loads);

  Eigen::VectorXd pushed = Eigen::VectorXd::Zero(m.position.size()), all = pushed;
  loads[0](m.position, pushed, nullptr);
  for (auto const& load : loads) load(m.position, all, nullptr);
  add_elastic_force(m, m.position, all);
  double push = 0, rim = 0;
  for (int i = 0; i < pushed.size(); i += 2) {
    push += pushed[i];
    if (m.fixed[i]) rim += all[i];
  }
  double const held = stop_force(m, stop, m.position);
  EXPECT_GT(held, 0.3 * push);
  EXPECT_NEAR(held, push - rim, 1e-9 * push);
  for (int n : nodes_within(m, stop.radius))
    EXPECT_LT(m.position[2 * n] + H / 2, stop.position + 1e-3 * H);
}

}  // namespace
}  // namespace velum::structure
