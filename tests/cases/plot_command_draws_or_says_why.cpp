// Problem: velum plot on folders with and without results.
// Reference: the command's own promise: pictures and one page that needs no other file, or one
//   sentence and exit code 2.
// Measure: exit code, sentence, what the page holds.
// Tolerance: none.
// Why: words and files are there or not. Where there is no Python with matplotlib the pictures
//   cannot be looked for; the sentence that says so is then what is promised.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cases/scene_file.hpp"
#include "tests/core/scratch.hpp"
#include "tests/support/program.hpp"

namespace velum::tests {
namespace {

struct PlotCommand : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path run = folder.path / "run";

  void SetUp() override
  {
    std::filesystem::create_directories(run);
    std::ofstream series(run / "series.csv");
    series << "time [s],pressure_above [Pa],pressure_outside [Pa],pressure_inside [Pa],gap [m],"
              "flow [m3/s],lift_pilot [m]\n";
    for (int k = 0; k < 60; ++k)
      series << 1e-3 * k << ",3e5,3e5,0," << 1e-6 * k << ',' << 1e-7 * k << ",4e-4\n";
    std::ofstream(run / "summary.json") << R"({"valve_kv": {"value": 0.1155, "unit": "m3/h"},
      "valve_leak_class": {"value": null, "unit": "1"}, "assumptions": {"gap": "a <closure>"}})";
    std::ofstream(run / "paper.csv") << "quantity,time [s],value,unit,label\nflow,0.03,100,l/h,p\n";
  }

  Outcome plot(std::filesystem::path const& of) { return velum_program("plot " + of.string()); }

  void expect_refused(std::filesystem::path const& of, std::string const& words)
  {
    auto const outcome = plot(of);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.text.find('\n'), outcome.text.size() - 1) << outcome.text;
  }
};

TEST_F(PlotCommand, WritesAPageThatNeedsNoOtherFile)
{
  auto const outcome = plot(run);
  if (outcome.exit_code == 2) {
    EXPECT_NE(outcome.text.find("takes a Python with matplotlib"), std::string::npos);
    GTEST_SKIP() << outcome.text;
  }
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  auto const page = text_of(run / "run.html");
  EXPECT_TRUE(std::filesystem::exists(run / "history.png"));
  EXPECT_TRUE(std::filesystem::exists(run / "spectrum.png"));
  EXPECT_NE(page.find("data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(page.find("0.1155 m³/h"), std::string::npos);
  EXPECT_NE(page.find("a &lt;closure&gt;"), std::string::npos);
  EXPECT_EQ(page.find("src=\"history"), std::string::npos);
}

TEST_F(PlotCommand, SaysInASentenceWhatIsMissing)
{
  expect_refused(folder.path / "none", "there is no such folder of results");
  expect_refused(folder.path, "there is no series.csv of a run in this folder");
  std::ofstream(run / "series.csv") << "time [s],gap [m]\n0,0\n";
  expect_refused(run, "a picture takes two rows");
}

TEST_F(PlotCommand, SaysInASentenceThatThereIsNoPython)
{
  setenv("PYTHON", "/no/such/python", 1);
  expect_refused(run,
                 "takes a Python with matplotlib, numpy and h5py, and /no/such/python is none");
  unsetenv("PYTHON");
}

}  // namespace
}  // namespace velum::tests
