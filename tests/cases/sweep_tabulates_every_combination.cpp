// Problem: what velum sweep makes of its lists of values: combinations, folders, table, lines.
// Reference: the command's own promise.
// Measure: values, their order, text of sweep.csv, sentences.
// Tolerance: none.
// Why: words are there or not.
#include <gtest/gtest.h>

#include <limits>

#include "cases/app/sweep.hpp"
#include "core/check.hpp"

namespace velum::tests {
namespace {

using Words = std::vector<std::string>;
using cases::SweepRun;

Words values(std::string const& text) { return cases::read_axes({text}).front().values; }

/// The sentence with which the lists are refused; empty when they are accepted.
std::string over_refusal(Words const& texts)
{
  try {
    cases::read_axes(texts);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return {};
}

TEST(SweepValues, AreSplitAtCommas)
{
  EXPECT_EQ(values("inlet.pressure=50 kPa,100 kPa"), (Words{"50 kPa", "100 kPa"}));
  EXPECT_EQ(cases::read_axes({" inlet.pressure = 50 kPa "}).front().key, "inlet.pressure");
  EXPECT_EQ(values("contact.seat=\"a = b\", c"), (Words{"\"a = b\"", "c"}));
}

TEST(SweepValues, KeepTheCommasOfTablesAndQuotes)
{
  EXPECT_EQ(values("x=[[0 ms, 0 mm], [1 ms, 2 mm]],3 mm"),
            (Words{"[[0 ms, 0 mm], [1 ms, 2 mm]]", "3 mm"}));
  EXPECT_EQ(values("x=[{ a = 1, b = 2 }], [ ]"), (Words{"[{ a = 1, b = 2 }]", "[ ]"}));
  EXPECT_EQ(values(R"(x="a, \", b",'c, "d',e)"), (Words{R"("a, \", b")", "'c, \"d'", "e"}));
  EXPECT_EQ(values("x=\"[\",\"]\""), (Words{"\"[\"", "\"]\""}));
}

TEST(SweepValues, AreRefusedInASentence)
{
  EXPECT_EQ(over_refusal({"inlet.pressure"}),
            "--over: \"inlet.pressure\" is not of the form key=value,value, such as "
            "inlet.pressure=\"50 kPa,100 kPa\".");
  EXPECT_EQ(over_refusal({"x= "}), "--over: x has no value; write key=value,value.");
  EXPECT_EQ(over_refusal({"x=1,,2"}), "--over: x has an empty value between its commas.");
  EXPECT_EQ(over_refusal({"x=1,"}), "--over: x has an empty value between its commas.");
  EXPECT_EQ(over_refusal({"x=1,2,1"}), "--over: x has the value 1 twice.");
  EXPECT_EQ(over_refusal({"x=1", "x=2"}),
            "--over: x is given twice; write all its values in one list.");
  EXPECT_EQ(over_refusal({"x=[1,2"}), "--over: x lacks a ].");
  EXPECT_EQ(over_refusal({"x=[1}"}), "--over: x has a } that closes nothing.");
  EXPECT_EQ(over_refusal({"x=\"1,2"}), "--over: x has a quotation mark \" that is not closed.");
}

TEST(Sweep, RunsEveryCombinationTheLastKeyFastest)
{
  auto const runs = cases::sweep_runs(
      cases::read_axes({"inlet.pressure=50 kPa,1 bar", "a.lift=20 um,[1 um, 2 um]"}));
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[0].values, (Words{"50 kPa", "20 um"}));
  EXPECT_EQ(runs[1].values, (Words{"50 kPa", "[1 um, 2 um]"}));
  EXPECT_EQ(runs[2].values, (Words{"1 bar", "20 um"}));
  EXPECT_EQ(runs[2].folder, "pressure_1bar_lift_20um");
  EXPECT_EQ(runs[3].folder, "pressure_1bar_lift_no2");
}

TEST(Sweep, GivesEachRunAFolderOfItsOwn)
{
  auto const folder = [](Words const& axes, std::size_t run) {
    return cases::sweep_runs(cases::read_axes(axes))[run].folder;
  };
  EXPECT_EQ(folder({"inlet.pressure=1 kPa", "outlet.pressure=2 kPa"}, 0),
            "inlet.pressure_1kPa_outlet.pressure_2kPa");
  EXPECT_EQ(folder({"x=1 2,12"}, 0), "x_no1");
  EXPECT_EQ(folder({"x=1 2,12"}, 1), "x_no2");
  EXPECT_EQ(folder({"x=../../home,-1e-3 m/s"}, 1), "x_-1e-3ms");
  EXPECT_EQ(folder({"x=../../home,-1e-3 m/s"}, 0), "x_....home");
}

/// A sweep of two runs that came to their end, one that failed, and one that is still to be run.
struct Table {
  std::vector<cases::SweepAxis> axes = cases::read_axes({"p=1 kPa,2 kPa", "t=\"a,b\",c"});
  std::vector<SweepRun> runs = cases::sweep_runs(axes);
  Table()
  {
    runs[0].outcome = runs[1].outcome = "ok";
    runs[0].figures = {{"force", 0.1, "N"}, {"wall_time", 3, "s"}};
    runs[1].figures = {{"force", 0.2, "N"},
                       {"gap", 2e-6, "m"},
                       {"leak", std::numeric_limits<double>::quiet_NaN(), "m3/s"}};
    runs[2].outcome = "Diverged at step 3, body \"fluid\".";
  }
};

TEST(SweepTable, HasTheFiguresOfAllRunsAndGapsWhereOneHasThemNot)
{
  Table const table;
  EXPECT_EQ(cases::csv(table.axes, table.runs),
            "p,t,outcome,force [N],wall_time [s],gap [m],leak [m3/s]\n"
            "1 kPa,\"\"\"a,b\"\"\",ok,0.1,3,,\n"
            "1 kPa,c,ok,0.2,,2e-06,nan\n"
            "2 kPa,\"\"\"a,b\"\"\",\"Diverged at step 3, body \"\"fluid\"\".\",,,,\n");
}

TEST(SweepTable, ShowsWhatIsAskedForOrDiffers)
{
  Table table;
  EXPECT_EQ(cases::shown_figures(table.runs, {"gap"}), Words{"gap"});
  EXPECT_EQ(cases::shown_figures(table.runs, {}), Words{"force"});
  EXPECT_EQ(cases::shown_figures({table.runs[1]}, {}), (Words{"force", "gap", "leak"}));
  EXPECT_EQ(cases::shown_figures({table.runs[2]}, {}), Words{});
  table.runs[1].figures.push_back({"chatter_frequency", 60, "Hz"});
  table.runs[0].figures.push_back({"valve_flow_final", 1e-6, "m3/s"});
  EXPECT_EQ(cases::shown_figures(table.runs, {}), (Words{"valve_flow_final", "chatter_frequency"}));
}

TEST(SweepTable, SaysARunInALine)
{
  Table const table;
  Words const shown{"gap", "force", "leak"};
  EXPECT_EQ(cases::run_text(table.axes, table.runs[1], shown),
            "1 kPa  c      gap 2 um, force 0.2 N, leak nan l/h");
  EXPECT_EQ(cases::run_text(table.axes, table.runs[2], shown),
            "2 kPa  \"a,b\"  Diverged at step 3, body \"fluid\".");
}

TEST(SweepTable, RefusesAFigureThatNoRunHas)
{
  Table const table;
  EXPECT_NO_THROW(cases::check_shown(table.runs, {"gap", "force"}));
  EXPECT_NO_THROW(cases::check_shown({table.runs[2]}, {"anything"}));
  try {
    cases::check_shown(table.runs, {"gap", "farce"});
    FAIL();
  } catch (core::InputError const& error) {
    EXPECT_STREQ(error.what(), "--show: no run has a figure farce; did you mean \"force\"?");
  }
}

}  // namespace
}  // namespace velum::tests
