#include "tests/cases/scene_file.hpp"
#include "tests/core/scratch.hpp"
#include "tests/core/stl_files.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

struct StlCommand : testing::Test {
  TemporaryFolder folder;
  std::string file = (folder.path / "plate.stl").string();
  std::string out = (folder.path / "out").string();

  void SetUp() override { write(file, binary_stl(cuboid({0, 0, 0}, {5, 3, 0.15}), "solid")); }

  Outcome run(std::string const& options, std::string const& name = "")
  {
    return velum_program("stl " + (name.empty() ? file : name) + " --threads 1 " + options);
  }

  /// Claims bad input with a sentence that contains these words.
  void expect_refused(std::string const& options, std::string const& words)
  {
    auto const outcome = run(options);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
  }
};

TEST_F(StlCommand, ReportsSizeAndWarnsOfAThinWall)
{
  auto const outcome = run("--unit mm --dx \"0.1 mm\"");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.text.find("5 x 3 x 0.15 mm"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("warning: the thinnest wall has 1.5 cells"), std::string::npos);
  EXPECT_NE(run("--unit \"25.4 mm\" --dx \"0.1 mm\"").text.find("127 x 76.2 x 3.81 mm"),
            std::string::npos);
}

TEST_F(StlCommand, WritesTheCutWithAndWithoutAPython)
{
  for (std::string const cut : {"x=0.5", "\"x=500 um\""}) {
    auto const outcome = run("--unit mm --dx \"50 um\" --cut " + cut + " --out " + out);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.text.find("x = 500 um: " + out + "/section_x.csv"), std::string::npos)
        << outcome.text;
    EXPECT_EQ(text_of(out + "/section_x.csv").substr(0, 21), "line [1],y [m],z [m]\n");
    EXPECT_NE(text_of(out + "/cells_x.csv").find("\n0,0.003,0,5e-05\n"), std::string::npos);
    bool const drawn = outcome.text.find("picture " + out + "/section_x.png") != std::string::npos;
    EXPECT_EQ(drawn, std::filesystem::exists(out + "/section_x.png"));
    EXPECT_NE(drawn, outcome.text.find("no picture: it takes a Python") != std::string::npos);
  }
  setenv("PYTHON", "/no/such/python", 1);
  auto const without = run("--unit mm --dx \"50 um\" --cut x=0.5 --out " + out);
  unsetenv("PYTHON");
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_NE(without.text.find("no picture: it takes a Python"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out + "/section_x.png"));
}

TEST_F(StlCommand, RefusesBadInputInASentence)
{
  expect_refused("--dx \"0.1 mm\"", "--unit");
  expect_refused("--unit kg --dx \"0.1 mm\"", "--unit: \"1 kg\" is a mass");
  expect_refused("--unit mm --dx 0.1", "--dx: \"0.1\" has no unit");
  expect_refused("--unit mm --dx \"0 mm\"", "--dx: \"0 mm\" is not a positive length.");
  expect_refused("--unit mm --dx \"0.1 mm\" --cut w=1", "--cut: \"w=1\" is no plane: write x, y");
  expect_refused("--unit mm --dx \"0.1 mm\" --cut x=1kg", "--cut: \"1kg\" is a mass");
  expect_refused("--unit mm --dx \"0.1 mm\" --cut x=7 --out " + out,
                 "--cut: the plane x = 7 mm does not cut the solid, which goes from 0 mm to 5 mm.");
  expect_refused("--unit mm --dx \"1 nm\" --cut x=1 --out " + out, "choose a larger --dx");
  EXPECT_FALSE(std::filesystem::exists(out));

  auto const missing = run("--unit mm --dx \"0.1 mm\"", "no_such_part.stl");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(missing.text, "no_such_part.stl: there is no such STL file.\n");
}

}  // namespace
}  // namespace velum::tests
