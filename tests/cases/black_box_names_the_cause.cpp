// problem:   the small valve with a failure planted in it: a lattice velocity near that of its
//            sound, sub-steps longer than stable, a contact far stiffer than its sub-steps bear, an
//            inlet that jumps to 20 MPa
// reference: what was planted
// measure:   the first of the likely causes
// tolerance: none
// why:       the quantity that leaves its usual range first is that of the part that fails
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "cases/app/black_box.hpp"
#include "cases/app/coupled_march.hpp"
#include "cases/app/coupled_watch.hpp"
#include "cases/app/settled_state.hpp"
#include "tests/cases/long_run.hpp"
#include "tests/core/scratch.hpp"

namespace velum::tests {
namespace {

using cases::BlackBox;
using cases::Cause;
using Failing = cases::CoupledScene<double, ibm::Sharp>;

/// Marches a scene, altered, until it diverges; the causes in their order.
std::vector<Cause> causes(std::string const& text, std::vector<std::string> const& set,
                          std::function<void(Failing&, long)> const& plant)
{
  auto const scene = read_text(text, set);
  auto const start = cases::make_start(scene);
  auto s = cases::make_coupled_scene<double, ibm::Sharp>(scene, start, 0);
  auto watch = cases::make_watch(s, scene);
  double const dt = s.derived.units.dt;
  long n = 0;
  try {
    for (n = 1; n <= 4000; ++n) {
      plant(s, n);
      take_step(s, scene, n, false);
      note_step(watch, s, scene, n, double(n) * dt);
      if (n % 200 != 0) continue;
      auto const seen = lbm::observe(s.state.fluid);
      note_look(watch, s, seen, n, double(n) * dt);
      guard(s, seen, n);
    }
  } catch (core::Divergence const&) {
    if (watch.steps.rows.empty() || watch.steps.rows.back().step < n)
      note_step(watch, s, scene, n, double(n) * dt);
  }
  auto const found = cases::departures({&watch.looks, &watch.steps});
  std::vector<Cause> order;
  for (auto const& d : found) order.push_back(d.what.cause);
  testing::Test::RecordProperty("causes", cases::in_words(found));
  return order;
}

TEST(BlackBox, NamesAFluidThatFails)
{
  auto const found =
      causes(quick_piloted_valve,
             {"lattice.mach=0.9", "lattice.collision=trt", "fluid.viscosity=1e-10 m2/s"},
             [](auto&, long) {});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), Cause::fluid);
}

TEST(BlackBox, NamesAMembraneWhoseSubStepsAreTooLong)
{
  auto const found = causes(quick_valve, {"coupling.membrane=explicit"}, [](Failing& s, long n) {
    if (n == 500) s.state.membrane.material.c10 *= 1e5;
  });
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), Cause::structure);
}

TEST(BlackBox, NamesAContactTooStiffForItsSubSteps)
{
  auto const found = causes(quick_valve, {"coupling.membrane=explicit"}, [](Failing& s, long n) {
    if (n == 500) s.state.seat->contact.stiffness *= 1e4;
  });
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), Cause::contact);
}

TEST(BlackBox, NamesAnInputThatJumps)
{
  auto const found = causes(edited(quick_valve, "pressure = \"50 kPa\"",
                                   "pressure = [[\"0 s\", \"50 kPa\"], [\"0.4 ms\", \"50 kPa\"], "
                                   "[\"0.401 ms\", \"20 MPa\"]]"),
                            {"lattice.time_step=1 us"}, [](auto&, long) {});
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), Cause::input);
}

/// A box in which quantity k rises at step 50 + 5 k.
TEST(BlackBox, OrdersCausesByTheStepAtWhichTheyLeaveTheirRange)
{
  BlackBox box{{{"a", "1", Cause::contact}, {"b", "1", Cause::structure}, {"c", "1", Cause::fluid}},
               60};
  for (long n = 0; n < 70; ++n)
    note(box, n, double(n),
         {n >= 50 ? 20.0 : 1.0, n >= 55 ? std::nan("") : 1.0, n == 30 ? 100.0 : 1.0});
  EXPECT_EQ(box.rows.size(), 60u);
  auto const found = cases::departures({&box});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].what.name, "a");
  EXPECT_EQ(found[0].step, 50);
  EXPECT_EQ(found[1].what.name, "b");
  EXPECT_EQ(found[1].step, 55);
}

TEST(BlackBox, OfARunIsWrittenAndTheLastGoodStateStays)
{
  SceneRuns const valve(edited(
      quick_valve, "pressure = \"50 kPa\"",
      "pressure = [[\"0 s\", \"50 kPa\"], [\"1 ms\", \"50 kPa\"], [\"1.001 ms\", \"20 MPa\"]]"));
  std::string said;
  try {
    valve.run("run", {"lattice.time_step=1 us"});
  } catch (core::Divergence const& failure) {
    said = failure.what();
  }
  auto const last = cases::newest_checkpoint(valve.out("run"));
  ASSERT_FALSE(last.empty()) << said;
  EXPECT_NE(said.find("Left its usual range first: input"), std::string::npos) << said;
  EXPECT_NE(said.find("The last good state is in " + last.string()), std::string::npos) << said;
  EXPECT_GT(text_of(valve.out("run") / "blackbox.csv").size(), 100u);
  EXPECT_GT(text_of(valve.out("run") / "blackbox_steps.csv").size(), 100u);
}

}  // namespace
}  // namespace velum::tests
