// problem:   the small piloted valve, its pilot open since 0.5 ms, taken to a time step of 0.7 of
//            its own in full motion; and the small valve under an inlet whose rise to 4 MPa its
//            time step cannot carry
// reference: the state before; 0.1 ms later the run that had the shorter step from its beginning;
//            a restart from what the run that fell back has left
// measure:   pressures, flow, place of the membrane; populations there and back; exit and series
// tolerance: 1e-9 at once and there and back; later a fifth of the distance between runs with
//            either step, the largest of three pressures
// why:       SI quantities are the same up to rounding. Later they go over to those of the shorter
//            step: openings let sound out against rho c_s U, which follows the lattice's Mach
//            number, and 0.1 ms are two passages of sound, which leave 10 % of the distance
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cases/app/coupled_march.hpp"
#include "cases/app/fall_back.hpp"
#include "cases/app/settled_state.hpp"
#include "tests/cases/long_run.hpp"
#include "tests/core/scratch.hpp"

namespace velum::tests {
namespace {

using Valve = cases::CoupledScene<double, ibm::Sharp>;

Valve make_valve(cases::Scene const& scene)
{
  return cases::make_coupled_scene<double, ibm::Sharp>(scene, cases::make_start(scene), 0);
}

void take_steps(Valve& s, cases::Scene const& scene, cases::Flows& flows, double from, double to)
{
  double const dt = s.derived.units.dt;
  for (long n = std::lround(from / dt) + 1; n <= std::lround(to / dt); ++n) {
    take_step(s, scene, n, false);
    add_flows(flows, s);
  }
}

double largest_difference(Valve const& a, Valve const& b)
{
  double most = 0;
  auto const &f = a.state.fluid.f, &g = b.state.fluid.f;
  for (int j = 0; j < a.state.fluid.ny; ++j)
    for (int i = 0; i < a.state.fluid.nx; ++i) {
      int const cell = a.state.fluid.cell(i, j);
      if (!a.state.fluid.active(cell)) continue;
      for (int d = 0; d < 9; ++d)
        most = std::max(most, std::abs(f.outgoing(d, cell) - g.outgoing(d, cell)));
    }
  return most;
}

TEST(FallBack, KeepsTheStateInSiUnits)
{
  double const time = 0.7e-3, later = 0.8e-3;
  auto const scene = read_text(quick_piloted_valve), slow = cases::slower(scene);
  cases::Flows flows, slow_flows, other_flows;
  auto valve = make_valve(scene), slow_valve = make_valve(slow), back = make_valve(scene);
  take_steps(valve, scene, flows, 0, time);
  slow_flows = flows;
  carry_over(valve, slow_valve, slow_flows);
  auto again = slow_flows;
  carry_over(slow_valve, back, again);
  EXPECT_LT(largest_difference(valve, back), 1e-9 * 0.01);
  EXPECT_LT((valve.state.membrane.velocity - back.state.membrane.velocity).norm(), 1e-12);

  auto before = measure(valve, scene, flows, time);
  auto after = measure(slow_valve, slow, slow_flows, time);
  double const share = 1e-9, p = 50e3, travel = 1e-3;
  EXPECT_NEAR(after.pressure_above, before.pressure_above, share * p);
  EXPECT_NEAR(after.pressure_outside, before.pressure_outside, share * p);
  EXPECT_NEAR(after.pressure_inside, before.pressure_inside, share * p);
  EXPECT_NEAR(after.centre, before.centre, share * travel);
  EXPECT_NEAR(after.flow / before.flow, 1, share);
  EXPECT_NEAR(after.outflow / before.outflow, 1, share);
  EXPECT_NEAR(after.volume_inside / before.volume_inside, 1, share);
  for (std::size_t k : {0, 1, 2}) EXPECT_NEAR(after.network[k] / before.network[k], 1, share);

  auto other = make_valve(slow);  // that step from the beginning
  take_steps(other, slow, other_flows, 0, later);
  take_steps(valve, scene, flows, time, later);
  take_steps(slow_valve, slow, slow_flows, time, later);
  before = measure(valve, scene, flows, later);
  after = measure(slow_valve, slow, slow_flows, later);
  auto const slower = measure(other, slow, other_flows, later);
  auto const distance = [&](cases::Measurement const& m) {
    return std::max({std::abs(m.pressure_above - slower.pressure_above),
                     std::abs(m.pressure_outside - slower.pressure_outside),
                     std::abs(m.pressure_inside - slower.pressure_inside)});
  };
  EXPECT_LT(distance(after), 0.2 * distance(before));
}

TEST(FallBack, TakesARunThroughWhatItsOwnStepCannotCarry)
{
  SceneRuns const valve(edited(
      edited(
          quick_valve, "pressure = \"50 kPa\"",
          "pressure = [[\"0 s\", \"50 kPa\"], [\"0.6 ms\", \"50 kPa\"], [\"0.7 ms\", \"4 MPa\"]]"),
      "shear_modulus = \"1 MPa\"", "shear_modulus = \"100 MPa\""));
  std::vector<std::string> set = {"lattice.time_step=1.6 us", "run.checkpoint_every=0.3 ms"};
  EXPECT_THROW(valve.run("fails", set), core::Divergence);
  set.push_back("run.fall_back=3");
  ASSERT_TRUE(valve.run("passes", set));
  auto const last = cases::newest_checkpoint(valve.out("passes"));
  EXPECT_GE(cases::times_fallen(last), 1);

  auto const series = text_of(valve.out("passes") / "series.csv");
  std::filesystem::copy(valve.out("passes"), valve.out("again"));
  ASSERT_TRUE(valve.run("again", set, last));  // a checkpoint after it is gone on from as well
  EXPECT_EQ(text_of(valve.out("again") / "series.csv"), series);
}

}  // namespace
}  // namespace velum::tests
