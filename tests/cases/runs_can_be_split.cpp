// problem:   the small valve on cells of 200 um for 1.5 ms, some thousand steps: whole, split in
// the
//            middle, stopped at ten random places, killed at ten
// reference: the run that was not interrupted
// measure:   series.csv, times of the dumps, and every array of the last checkpoint but wall times
// tolerance: none, every bit
// why:       what a step reads is in the checkpoint or follows from it
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <random>
#include <thread>

#include "tests/cases/long_run.hpp"
#include "tests/core/scratch.hpp"
#include "tests/support/program.hpp"

namespace velum::tests {
namespace {

using Differences = std::vector<std::string>;

void expect_same_run(std::filesystem::path const& a, std::filesystem::path const& b,
                     std::set<std::string> const& but = {})
{
  std::set<std::string> ignored = {"wall time", "wall time of the membrane", "checkpoints"};
  ignored.insert(but.begin(), but.end());
  EXPECT_FALSE(text_of(a / "series.csv").empty());
  EXPECT_EQ(text_of(a / "series.csv"), text_of(b / "series.csv"));
  EXPECT_EQ(text_of(a / "run.xmf"), text_of(b / "run.xmf"));
  EXPECT_EQ(differences(cases::newest_checkpoint(a), cases::newest_checkpoint(b), ignored),
            Differences());
}

/// The older of the two checkpoints that a run has left.
std::filesystem::path older(std::filesystem::path const& folder)
{
  bool const a = cases::newest_checkpoint(folder).filename() == "checkpoint_a.h5";
  return folder / (a ? "checkpoint_b.h5" : "checkpoint_a.h5");
}

void copy_results(std::filesystem::path const& from, std::filesystem::path const& to)
{
  std::filesystem::create_directories(to);
  for (auto const* name : {"run.h5", "run.xmf", "series.csv"})
    std::filesystem::copy_file(from / name, to / name);
}

void expect_split_run_is_whole_run(std::string const& text, std::vector<std::string> const& set)
{
  SceneRuns const valve(text);
  ASSERT_TRUE(valve.run("whole", set));
  copy_results(valve.out("whole"), valve.out("split"));
  ASSERT_TRUE(valve.run("split", set, older(valve.out("whole"))));
  expect_same_run(valve.out("whole"), valve.out("split"));
}

TEST(SplitRun, IsTheWholeRunWithExplicitSubSteps)
{
  expect_split_run_is_whole_run(quick_valve,
                                {"coupling.membrane=explicit", "run.checkpoint_every=0.7 ms"});
}

TEST(SplitRun, IsTheWholeRunWithImplicitSteps)
{
  expect_split_run_is_whole_run(
      quick_valve,
      {"coupling.membrane=implicit", "run.checkpoint_every=0.7 ms", "membrane.bending=on"});
}

TEST(SplitRun, IsTheWholeRunWithChambers)
{
  expect_split_run_is_whole_run(quick_piloted_valve, {"run.checkpoint_every=0.7 ms"});
}

TEST(SplitRun, IsTheWholeRunWithTheGapLeftToALaw)
{
  expect_split_run_is_whole_run(
      edited(quick_piloted_valve, "[material.rubber]", "[gap]\ncells = 2\n[material.rubber]"),
      {"run.settle=1 ms", "run.checkpoint_every=0.35 ms"});
}

TEST(SplitRun, IsTheWholeRunInSinglePrecisionAndWithTheInletShut)
{
  expect_split_run_is_whole_run(quick_valve, {"lattice.precision=single", "run.settle=0.9 ms",
                                              "run.shut=0.6 ms", "run.checkpoint_every=0.5 ms"});
}

TEST(SplitRun, StoppedAtTenRandomPlacesEndsInTheSameState)
{
  SceneRuns const valve(quick_valve);
  ASSERT_TRUE(valve.run("whole"));
  std::mt19937 random(1);
  bool done = false;
  for (int k = 0; k < 10 && !done; ++k) {
    std::thread stop([delay = random() % 50] {
      std::this_thread::sleep_for(std::chrono::milliseconds(delay));
      cases::request_stop();
    });
    done = valve.run("split", {}, cases::newest_checkpoint(valve.out("split")));
    stop.join();
    cases::request_stop(false);
  }
  if (!done) valve.run("split", {}, cases::newest_checkpoint(valve.out("split")));
  expect_same_run(valve.out("whole"), valve.out("split"),
                  {"next checkpoint"});  // a stop adds one of its own and moves none
}

TEST(SplitRun, StoppedBySignalSaysHowToGoOn)
{
  SceneRuns const valve(quick_valve);
  std::filesystem::create_directories(valve.out("run"));
  cases::request_stop();
  try {
    cases::run_coupled(cases::read_scene(valve.folder.path / "scene.toml"),
                       {.out = valve.out("run"), .quiet = true});
    ADD_FAILURE() << "was not stopped";
  } catch (cases::Stopped const& stopped) {
    EXPECT_NE(std::string(stopped.what())
                  .find("go on with --restart " + (valve.out("run") / "checkpoint_a.h5").string()),
              std::string::npos)
        << stopped.what();
  }
  cases::request_stop(false);
}

/// Starts the program and kills it after a time, s; true where it had come to its end.
bool run_for(std::vector<std::string> arguments, double seconds)
{
  pid_t const child = fork();
  if (child == 0) {
    std::vector<char*> argv;
    arguments.insert(arguments.begin(), VELUM_PROGRAM);
    for (auto& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    execv(VELUM_PROGRAM, argv.data());
    _exit(127);
  }
  int status = 0;
  for (double waited = 0; waited < seconds; waited += 0.002) {
    if (waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  kill(child, SIGKILL);
  waitpid(child, &status, 0);
  return false;
}

TEST(SplitRun, KilledAtTenRandomPlacesEndsInTheSameState)
{
  SceneRuns const valve(edited(quick_valve, "settle = \"1.5 ms\"",
                               "settle = \"8 ms\"\ncheckpoint_every = \"0.1 ms\""));
  ASSERT_TRUE(valve.run("whole"));
  std::mt19937 random(2);
  int killed = 0;
  bool done = false;
  while (!done) {
    std::vector<std::string> arguments = {"run",
                                          (valve.folder.path / "scene.toml").string(),
                                          "--quiet",
                                          "--threads",
                                          "1",
                                          "--out",
                                          valve.out("split").string()};
    if (auto const last = cases::newest_checkpoint(valve.out("split")); !last.empty())
      arguments.insert(arguments.end(), {"--restart", last.string()});
    done = run_for(arguments, killed < 10 ? 0.05 + 0.001 * double(random() % 100) : 100);
    killed += !done;
  }
  EXPECT_GE(killed, 3);
  expect_same_run(valve.out("whole"), valve.out("split"));
}

TEST(SplitRun, GoesOnInAnotherFolderAndLonger)
{
  SceneRuns const valve(quick_valve);
  ASSERT_TRUE(valve.run("short"));
  auto const last = cases::newest_checkpoint(valve.out("short")).string();
  auto const more = velum_program("run " + (valve.folder.path / "scene.toml").string() +
                                  " --quiet --threads 1 --set run.settle='2 ms' --restart " + last +
                                  " --out " + valve.out("long").string());
  ASSERT_EQ(more.exit_code, 0) << more.text;
  auto const before = text_of(valve.out("short") / "series.csv");
  auto const after = text_of(valve.out("long") / "series.csv");
  EXPECT_GT(after.size(), before.size());
  EXPECT_EQ(after.substr(0, before.size() / 2), before.substr(0, before.size() / 2));
}

TEST(SplitRun, OfAnotherLatticeOrTimeStepIsRefused)
{
  SceneRuns const valve(quick_valve);
  ASSERT_TRUE(valve.run("whole", {"run.settle=0.3 ms"}));
  auto const last = cases::newest_checkpoint(valve.out("whole"));
  auto const refused = [&](std::string const& set) {
    try {
      valve.run("other", {set}, last);
    } catch (core::InputError const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused("inlet.pressure=60 kPa").find("another time step"), std::string::npos);
  EXPECT_NE(refused("lattice.precision=single").find("precision"), std::string::npos);
  EXPECT_NE(refused("lattice.to=[\"2.4 mm\", \"6 mm\"]").find("another lattice or membrane"),
            std::string::npos);
}

}  // namespace
}  // namespace velum::tests
