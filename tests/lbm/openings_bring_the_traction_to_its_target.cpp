// problem:   a traction inlet switched on at once: a channel with a step and an outflow at its end;
//            a tube closed at its end, at nu = 0.001 to 0.1; a channel out of which a rate is drawn
//            that grows steadily
// reference: the mean normal traction is the target; in the closed tube the fluid comes to rest and
//            the pressure is the target everywhere; while the flow grows, traction = target -
//            c_s/gain dU/dt (opening.hpp)
// measure:   mean traction over the last 2000 steps; velocity, pressure at the end, highest
//            traction; what the traction is short of its target, over dU/dt c_s/gain
// tolerance: 0.1 %; closed tube: speed 1e-3 of p/(rho c_s), overshoot 20 %, at half the gain that
//            the tube just stands too; growing flow 5 %
// why:       the control has integral action, so the error dies out; the integral winds up while
//            the tube fills, which is the overshoot (7 to 13 % seen in tubes of 120 cells, at
//            either gain); the growing flow shears the walls, whose share in the traction is not in
//            the formula
#include <gtest/gtest.h>

#include <cmath>

#include "lbm/observe.hpp"
#include "tests/support/flow.hpp"

namespace velum {
namespace {

double mean_traction(tests::Flow<double>& flow, int steps, double& highest)
{
  double sum = 0;
  for (int t = 0; t < steps; ++t) {
    tests::step(flow);
    highest = std::max(highest, flow.openings[0].traction);
    if (t >= steps - 2000) sum += flow.openings[0].traction / 2000;
  }
  return sum;
}

lbm::Fluid<double> fluid(int nx, int ny, double nu)
{
  return lbm::make_fluid<double>(nx, ny, {0, 0}, core::Symmetry::planar,
                                 {lbm::Collision::central_moments, nu, 1.0 / 8});
}

TEST(TractionInlet, ReachesItsTargetInAChannelWithAStep)
{
  for (double target : {0.001, 0.01}) {
    auto flow = tests::make_flow(
        fluid(50, 12, 0.05), core::box({20, 4}, {30, 100}), tests::open_ends(50),
        {{lbm::OpeningKind::traction, {1, 0}, target}, {lbm::OpeningKind::outflow, {-1, 0}, 0.0}});
    double highest = 0;
    EXPECT_NEAR(mean_traction(flow, 50000, highest) / target, 1, 1e-3);
    EXPECT_GT(flow.openings[0].mass_flow, 0);
    EXPECT_NEAR(flow.openings[0].mass_flow / -flow.openings[1].mass_flow, 1, 1e-2);
  }
}

TEST(TractionInlet, FillsAClosedTube)
{
  double const target = 0.003, sound = 1 / std::sqrt(3.0);
  for (double nu : {0.001, 0.01, 0.1})
    for (bool high : {false, true}) {
      auto flow = tests::make_flow(
          fluid(120, 12, nu), tests::no_solids(),
          [](lbm::WallHit const& h) { return h.i == 0 && lbm::D2Q9::cx(h.dir) < 0 ? 0 : -1; },
          {{lbm::OpeningKind::traction, {1, 0}, target}});
      if (high) flow.openings[0].gain = 0.5 * sound / (4 * 120);
      double highest = 0;
      EXPECT_NEAR(mean_traction(flow, 25000, highest) / target, 1, 1e-3) << nu;
      EXPECT_LT(highest / target, 1.2) << nu;
      EXPECT_LT(lbm::observe(flow.fluid).speed_max, 1e-2 * target / sound) << nu;
      EXPECT_LT(std::abs(flow.openings[0].velocity), 1e-3 * target / sound) << nu;
      EXPECT_NEAR(lbm::cell_states(flow.fluid)(6, 110).rho / 3 / target, 1, 1e-3) << nu;
    }
}

TEST(TractionInlet, StaysBehindAGrowingFlowAsItsGainHasIt)
{
  double const target = 0.003, rate = 1e-8, sound = 1 / std::sqrt(3.0);  // rate: dU/dt
  for (double gain : {2e-4, 1e-3}) {
    auto flow = tests::make_flow(fluid(60, 12, 0.01), tests::no_solids(), tests::open_ends(60),
                                 {{lbm::OpeningKind::traction, {1, 0}, target},
                                  {lbm::OpeningKind::flow_rate, {-1, 0}, 0.0}});
    flow.openings[0].gain = gain;
    double sum = 0;
    for (int t = 0; t < 40000; ++t) {
      flow.targets[1] = t < 20000 ? 0 : -rate * (t - 20000) * flow.openings[1].area;
      tests::step(flow);
      if (t >= 38000) sum += (target - flow.openings[0].traction) / 2000;
    }
    EXPECT_NEAR(sum / (sound * rate / gain), 1, 0.05) << gain;
  }
}

}  // namespace
}  // namespace velum
