// problem:   the small piloted valve, settled for 0.3 ms with its pilot passage shut, then marched
// reference: the same steps in one go, without a file between them
// measure:   every array of the state after settling and 100 steps later; series of runs that found
//            the settled state and of one that computed it
// tolerance: none, every bit
// why:       a state holds all that a step reads
#include <gtest/gtest.h>

#include "cases/app/assumptions.hpp"
#include "cases/app/settled_state.hpp"
#include "tests/cases/long_run.hpp"
#include "tests/core/scratch.hpp"

namespace velum::tests {
namespace {

using Differences = std::vector<std::string>;

std::string const settled_valve = quick_piloted_valve + "[start]\nsettle = \"0.3 ms\"\n";

/// The only file in the folder of states.
std::filesystem::path state_in(std::filesystem::path const& folder)
{
  std::filesystem::path found;
  for (auto const& entry : std::filesystem::directory_iterator(folder / "states")) {
    EXPECT_TRUE(found.empty()) << "two states where one would do: " << entry.path();
    found = entry.path();
  }
  return found;
}

void write_state(std::filesystem::path const& path, cases::CoupledScene<double, ibm::Sharp>& s)
{
  cases::Flows none;
  auto file = core::StateFile::create(path);
  exchange_state(file, s, none);
  file.commit();
}

void take_steps(cases::CoupledScene<double, ibm::Sharp>& s, cases::Scene const& scene, long steps,
                bool held)
{
  for (long n = 1; n <= steps; ++n) take_step(s, scene, n, false, held);
}

TEST(SettledState, IsThatOfAStraightRunAndSoIsWhatFollows)
{
  SceneRuns const valve(settled_valve);
  auto const scene = cases::read_scene(valve.folder.path / "scene.toml");
  std::filesystem::create_directories(valve.out("run"));
  cases::RunOptions const options{.out = valve.out("run"), .quiet = true};
  auto start = cases::make_start(scene);
  auto branch = cases::make_settled_scene<double>(scene, scene, start, 0, options);

  auto own = cases::make_start(scene);
  auto straight = cases::make_coupled_scene<double, ibm::Sharp>(scene, own, 0);
  take_steps(straight, scene, std::lround(0.3e-3 / straight.derived.units.dt), true);
  cases::Flows none;
  restart_sums(straight, none);
  write_state(valve.out("straight.h5"), straight);
  EXPECT_EQ(differences(valve.out("straight.h5"), state_in(valve.folder.path)), Differences());

  take_steps(branch, scene, 100, false);
  take_steps(straight, scene, 100, false);
  write_state(valve.out("straight.h5"), straight);
  write_state(valve.out("branch.h5"), branch);
  EXPECT_EQ(differences(valve.out("straight.h5"), valve.out("branch.h5")), Differences());
}

TEST(SettledState, FoundIsTheSameAsComputedAndADamagedOneIsComputedAnew)
{
  SceneRuns const valve(settled_valve);
  std::vector<std::string> const set = {"run.settle=0.3 ms"};
  ASSERT_TRUE(valve.run("computed", set));
  auto const state = state_in(valve.folder.path);
  auto const written = std::filesystem::last_write_time(state);
  ASSERT_TRUE(valve.run("found", set));
  EXPECT_EQ(std::filesystem::last_write_time(state), written);
  std::filesystem::resize_file(state, 1000);
  ASSERT_TRUE(valve.run("repaired", set));
  for (std::string const name : {"found", "repaired"}) {
    EXPECT_EQ(text_of(valve.out("computed") / "series.csv"),
              text_of(valve.out(name) / "series.csv"));
    EXPECT_EQ(differences(cases::newest_checkpoint(valve.out("computed")),
                          cases::newest_checkpoint(valve.out(name))),
              Differences());
  }
}

TEST(SettledState, IsSharedByScenesThatDifferOnlyLater)
{
  std::string const lift =
      "lift = [[\"0 ms\", \"0 mm\"], [\"0.3 ms\", \"0 mm\"], [\"0.5 ms\", \"0.5 mm\"]]";
  auto const name = [&](std::string const& text) {
    return cases::state_name(read_text(text), 1e-3);
  };
  auto const state = name(settled_valve);
  EXPECT_EQ(name(edited(settled_valve, lift, "lift = \"0 mm\"")), state);
  EXPECT_EQ(name(edited(settled_valve, "name = \"small_valve\"", "name = \"other\"")), state);
  EXPECT_EQ(name(edited(settled_valve, "settle = \"1.5 ms\"", "settle = \"9 ms\"")), state);
  EXPECT_EQ(name(edited(settled_valve, "pressure = \"50 kPa\"",
                        "pressure = [[\"0 s\", \"50 kPa\"], [\"1 ms\", \"40 kPa\"]]")),
            state);
  EXPECT_NE(name(edited(settled_valve, lift, "lift = \"0.1 mm\"")), state);
  EXPECT_NE(name(edited(settled_valve, "pressure = \"50 kPa\"", "pressure = \"51 kPa\"")), state);
  EXPECT_NE(name(edited(settled_valve, "\"1 MPa\"", "\"1.1 MPa\"")), state);
  EXPECT_NE(cases::state_name(read_text(settled_valve), 2e-3), state);
}

TEST(SettledState, MayBeThatOfAnotherScene)
{
  SceneRuns const valve(settled_valve + "scene = \"closed.toml\"\n");
  valve.write("closed.toml",
              edited(quick_piloted_valve, "[\"0.5 ms\", \"0.5 mm\"]", "[\"0.5 ms\", \"0 mm\"]"));
  valve.write("own.toml", settled_valve);
  std::vector<std::string> const set = {"run.settle=0.1 ms"};
  ASSERT_TRUE(valve.run("from_other", set));
  ASSERT_TRUE(valve.run("own", set, {}, "own.toml"));
  state_in(valve.folder.path);  // one serves both
  EXPECT_EQ(text_of(valve.out("from_other") / "series.csv"),
            text_of(valve.out("own") / "series.csv"));

  valve.write("closed.toml", edited(quick_piloted_valve, "\"1 MPa\"", "\"2 MPa\""));
  EXPECT_THROW(valve.run("other", set), core::InputError);
}

}  // namespace
}  // namespace velum::tests
