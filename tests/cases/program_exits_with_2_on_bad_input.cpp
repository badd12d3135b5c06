#include "tests/cases/scene_file.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

struct ProgramOnBadInput : testing::Test {
  TemporaryFolder folder;
  std::string scene = (folder.path / "scene.toml").string();

  void SetUp() override { std::ofstream(scene) << small_valve; }
};

TEST_F(ProgramOnBadInput, BadValueInTheSceneOrByOverride)
{
  auto const bad_key =
      velum_program("run " + scene + " --out " + folder.path.string() + "/out --set lattice.dxx=1");
  EXPECT_EQ(bad_key.exit_code, 2);
  EXPECT_NE(bad_key.text.find("--set: lattice.dxx is not a key"), std::string::npos)
      << bad_key.text;
  EXPECT_FALSE(std::filesystem::exists(folder.path / "out"));

  std::ofstream(scene) << edited(small_valve, "dx = \"100 um\"", "dx = \"-1 um\"");
  auto const bad_value = velum_program("check " + scene);
  EXPECT_EQ(bad_value.exit_code, 2);
  EXPECT_EQ(bad_value.text, scene + ":4: lattice.dx must be positive, but is \"-1 um\".\n");
}

TEST_F(ProgramOnBadInput, MissingFile)
{
  auto const outcome = velum_program("run no_such_scene.toml");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.text, "no_such_scene.toml: there is no such scene file.\n");
}

TEST_F(ProgramOnBadInput, OutputFolderThatCannotBeWritten)
{
  // A folder below a file: nobody can make it, not even root.
  auto const outcome = velum_program("run " + scene + " --out " + scene + "/out");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.text.find("--out: the results folder " + scene + "/out cannot be made"),
            std::string::npos)
      << outcome.text;
}

TEST_F(ProgramOnBadInput, OutputFolderOfTheSceneItself)
{
  auto const outcome = velum_program("run " + scene + " --out " + folder.path.string());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.text.find("holds the scene file itself"), std::string::npos) << outcome.text;
}

TEST_F(ProgramOnBadInput, MisuseOfTheCommandLine)
{
  EXPECT_EQ(velum_program("").exit_code, 2);
  EXPECT_EQ(velum_program("run").exit_code, 2);
  EXPECT_EQ(velum_program("run " + scene + " --nonsense").exit_code, 2);
  EXPECT_EQ(velum_program("info --threads 0").exit_code, 2);
  auto const outcome = velum_program("chek " + scene);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.text,
            "chek is not a command of velum; did you mean \"check\"? Commands: run, check, stl, "
            "mesh, chart, sweep, limits, fit, plot, bench, info.\n");
}

TEST_F(ProgramOnBadInput, GoodUseExitsWithZeroAndWithoutNoiseFromKokkos)
{
  EXPECT_EQ(velum_program("--help").exit_code, 0);
  EXPECT_EQ(velum_program("run --help").exit_code, 0);
  auto const info = velum_program("info --threads 1");
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_EQ(info.text.find("WARNING"), std::string::npos) << info.text;
  EXPECT_NE(info.text.find("toml++"), std::string::npos);
  auto const check =
      velum_program("check " + scene + " --threads 1 --set inlet.pressure=\"70 kPa\"");
  EXPECT_EQ(check.exit_code, 0) << check.text;
  EXPECT_NE(check.text.find("mass ratio"), std::string::npos);
}

}  // namespace
}  // namespace velum::tests
