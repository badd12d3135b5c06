#include <gtest/gtest.h>

#include "tests/cases/long_run.hpp"
#include "tests/support/program.hpp"

namespace velum::tests {
namespace {

std::string with(std::string const& more) { return refusal(small_valve + more); }

TEST(BadInputOfLongRuns, TimesMustBeTimesAndPositive)
{
  EXPECT_NE(
      with("checkpoint_every = \"1 mm\"\n").find("run.checkpoint_every: \"1 mm\" is a length"),
      std::string::npos);
  EXPECT_NE(with("checkpoint_every = \"0 s\"\n").find("run.checkpoint_every must be positive"),
            std::string::npos);
  EXPECT_NE(with("[start]\nsettle = \"-1 ms\"\n").find("start.settle must be positive"),
            std::string::npos);
  EXPECT_NE(with("[start]\n").find("start.settle is missing"), std::string::npos);
  EXPECT_NE(with("[start]\nsettel = \"1 ms\"\n").find("did you mean \"settle\"?"),
            std::string::npos);
  EXPECT_EQ(with("checkpoint_every = \"1 ms\"\n[start]\nsettle = \"1 ms\"\n"), "");
}

TEST(BadInputOfLongRuns, FallBackIsAFewTimes)
{
  for (std::string const times : {"0.5", "11", "-1", "\"2\""})
    EXPECT_NE(with("fall_back = " + times + "\n").find("run.fall_back must be a"),
              std::string::npos);
  EXPECT_EQ(with("fall_back = 2\n"), "");
}

TEST(BadInputOfLongRuns, AnotherSceneMustLieBesideTheFirst)
{
  std::string const start = "[start]\nsettle = \"1 ms\"\nscene = ";
  EXPECT_NE(with(start + "\"a/b.toml\"\n").find("without slashes"), std::string::npos);
  EXPECT_NE(with(start + "\"none.toml\"\n").find("there is no such file beside the scene"),
            std::string::npos);
  EXPECT_NE(with(start + "\"scene.toml\"\n").find("give the other scene another name"),
            std::string::npos);
}

TEST(BadInputOfLongRuns, OnlyASharpCoupledRunKeepsItsState)
{
  std::string const diffuse = "checkpoint_every = \"1 ms\"\n[coupling]\nmethod = \"diffuse\"\n";
  EXPECT_NE(with(diffuse).find("run.checkpoint_every is for fluid and membrane together"),
            std::string::npos);
  EXPECT_NE(refusal(edited(small_valve, "\"axisymmetric\"", "\"hydrostatic\"") +
                    "[start]\nsettle = \"1 ms\"\n")
                .find("start is for fluid and membrane together"),
            std::string::npos);
}

TEST(BadInputOfLongRuns, ARestartNeedsACheckpointOfSuchARun)
{
  SceneRuns const valve(quick_valve);
  auto const scene = (valve.folder.path / "scene.toml").string();
  auto const missing = velum_program("run " + scene + " --restart none.h5 --quiet");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.text.find("--restart: there is no such file as"), std::string::npos)
      << missing.text;
  auto const no_state = velum_program("run " + scene + " --quiet --restart " + scene + " --out " +
                                      valve.out("out").string());
  EXPECT_EQ(no_state.exit_code, 2);
  EXPECT_NE(no_state.text.find("is not an HDF5 file"), std::string::npos) << no_state.text;
  auto const flow = velum_program("run cases/pipe/scene.toml --restart " + scene);
  EXPECT_EQ(flow.exit_code, 2);
  EXPECT_NE(flow.text.find("no other run writes checkpoints"), std::string::npos) << flow.text;
}

}  // namespace
}  // namespace velum::tests
