// Problem: velum sweep of a membrane on its seat, whole, repeated, extended, with a run that fails,
//   with bad input, and stopped in the middle of a run.
// Reference: the command's own promise; for a figure of the table the summary of that run.
// Measure: exit code, sentences, sweep.csv, which runs are run again.
// Tolerance: none; a number reads back as the same double.
// Why: what is done lies in folders with the scene as it was run. Where there is no Python with
//   matplotlib the picture cannot be looked for.
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <thread>

#include "cases/app/commands.hpp"
#include "core/output/summary.hpp"
#include "tests/cases/long_run.hpp"
#include "tests/core/scratch.hpp"
#include "tests/support/program.hpp"

namespace velum::tests {
namespace {

/// Sweeps of the closed valve's equilibrium, some hundredths of a second each.
struct SweepCommand : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path out = folder.path / "sweep";

  Outcome sweep(std::string const& arguments) const
  {
    return velum_program(
        "sweep cases/closed_valve/scene.toml --set fidelity=hydrostatic"
        " --set membrane.element=400um --threads 1 --out " +
        out.string() + ' ' + arguments);
  }

  void expect_refused(std::string const& arguments, std::string const& begin) const
  {
    auto const outcome = sweep(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
    EXPECT_TRUE(outcome.text.starts_with(begin)) << outcome.text;
    EXPECT_EQ(outcome.text.find('\n'), outcome.text.size() - 1) << outcome.text;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
};

std::size_t count(std::string const& text, std::string const& part)
{
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST_F(SweepCommand, TabulatesAndDrawsAndRunsNothingTwice)
{
  std::string const arguments =
      "--over 'inlet.pressure=20 kPa,50 kPa' --over membrane.thickness='2 mm,1.5 mm'";
  auto const first = sweep(arguments);
  ASSERT_EQ(first.exit_code, 0) << first.text;
  EXPECT_EQ(count(first.text, " N, penetration "), 4u) << first.text;
  bool const can_draw = count(first.text, "The picture was not drawn") == 0;
  EXPECT_EQ(std::filesystem::exists(out / "sweep.png"), can_draw) << first.text;
  auto const table = text_of(out / "sweep.csv");
  EXPECT_EQ(count(table, "\n"), 5u) << table;
  EXPECT_TRUE(
      table.starts_with("inlet.pressure,membrane.thickness,outcome,centre_deflection_"
                        "hydrostatic [m],seat_force [N],"))
      << table;
  auto const run = out / "pressure_50kPa_thickness_1.5mm";
  auto const alone = core::read_summary(run / "summary.json").figures;
  EXPECT_NE(table.find(fmt::format("50 kPa,1.5 mm,ok,{},{},", alone[0].value, alone[1].value)),
            std::string::npos)
      << table;

  setenv("PYTHON", "/bin/true", 1);  // the picture is known by now
  auto const again = sweep(arguments);
  EXPECT_EQ(again.exit_code, 0) << again.text;
  EXPECT_EQ(count(again.text, "(done before)"), 4u) << again.text;
  EXPECT_EQ(text_of(out / "sweep.csv"), table);  // with the wall times of the first

  // one run more, and one that is of another scene by now
  std::ofstream(run / "scene.toml", std::ios::app) << "# changed\n";
  auto const more =
      sweep("--over 'inlet.pressure=20 kPa,50 kPa' --over membrane.thickness='2 mm,1.5 mm,1.8 mm'");
  unsetenv("PYTHON");
  EXPECT_EQ(count(more.text, "(done before)"), 3u) << more.text;
  EXPECT_EQ(count(text_of(out / "sweep.csv"), "\n"), 7u);
}

TEST_F(SweepCommand, GoesOnAfterARunThatFails)
{
  setenv("PYTHON", "/bin/true", 1);
  auto const outcome = sweep("--over 'membrane.thickness=0.02 mm,2 mm' --show seat_farce");
  unsetenv("PYTHON");
  EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
  EXPECT_NE(outcome.text.find("did you mean \"seat_force\"?"), std::string::npos) << outcome.text;
  auto const table = text_of(out / "sweep.csv");
  EXPECT_EQ(count(table, "\n"), 3u) << table;
  EXPECT_EQ(count(table, ",ok,"), 1u) << table;
}

TEST_F(SweepCommand, RefusesBadInputBeforeAnythingIsWritten)
{
  expect_refused("--over 'inlet.pressure=20 kPa,20 mm'",
                 "--over: inlet.pressure: \"20 mm\" is a length, and a pressure is expected");
  expect_refused("--over 'inlet.presure=20 kPa'",
                 "--over: inlet.presure is not a key of [inlet]; did you mean \"pressure\"?");
  expect_refused("--over 'inlat.pressure=20 kPa'", "--over: inlat is not a key of the scene");
  expect_refused("--over 'inlet.pressure=20 kPa' --set 'lattice.mach=3'",
                 "--set: lattice.mach must be below 1");
  expect_refused("--over inlet.pressure", "--over: \"inlet.pressure\" is not of the form");
}

// Asked to stop, a run without a lattice writes the summary of what it has.
TEST(SweepStopped, KeepsItsTableAndNotHalfARun)
{
  SceneRuns const valve(edited(edited(quick_piloted_valve, "\"axisymmetric\"", "\"lumped\""),
                               "settle = \"1.5 ms\"", "settle = \"100 s\""));
  cases::Options options{};
  options.scene = valve.folder.path / "scene.toml";
  options.over = {"inlet.pressure=20 kPa,50 kPa"};
  options.out = valve.out("sweep");
  options.quiet = true;
  auto const run = options.out / "pressure_20kPa";
  auto const logger = spdlog::default_logger();
  std::thread hand([&] {
    for (int k = 0; k < 4000 && !std::filesystem::exists(run / "series.csv"); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    cases::request_stop();
  });
  EXPECT_THROW(cases::sweep_command(options), cases::Stopped);
  hand.join();
  cases::request_stop(false);
  spdlog::set_default_logger(logger);
  EXPECT_FALSE(std::filesystem::exists(run / "summary.json"));
  EXPECT_EQ(text_of(options.out / "sweep.csv"), "inlet.pressure,outcome\n");
}

}  // namespace
}  // namespace velum::tests
