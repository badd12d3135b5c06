#include <gtest/gtest.h>

#include <sstream>

#include "cases/app/chart.hpp"
#include "cases/app/limits.hpp"
#include "tests/cases/flow_file.hpp"
#include "tests/support/program.hpp"

namespace velum::tests {
namespace {

std::string read(std::filesystem::path const& file)
{
  std::ifstream const in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::ptrdiff_t lines(std::string const& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Chart, HasARowForEveryWayAndMarksTheDefault)
{
  TemporaryFolder const out;
  auto const run = velum_program(
      "chart cases/taylor_green/scene.toml --threads 1 --set 'chart.dx=[125 mm, 62.5 mm]'"
      " --set 'lattice.dx=62.5 mm' --out " +
      out.path.string());
  ASSERT_EQ(run.exit_code, 0) << run.text;
  auto const table = read(out.path / "chart.csv");
  EXPECT_EQ(lines(table), 1 + 2 * 4 * 3) << table;
  EXPECT_NE(run.text.find("(default)"), std::string::npos) << run.text;
  EXPECT_NE(table.find("taylor_green,0.0625,central_moments,quadratic,double,"),
            std::string::npos)
      << table;
}

TEST(Chart, QuickLeavesTheFinestOut)
{
  auto const scene = cases::read_scene("cases/pipe/scene.toml");
  for (auto const& point : cases::chart_points(scene, true)) EXPECT_GT(point.dx, 0.6e-3);
  EXPECT_EQ(cases::chart_points(scene, false).size(),
            3 * cases::chart_points(scene, true).size() / 2);
}

TEST(Chart, ADivergenceIsARow)
{
  auto const scene = cases::read_scene("cases/shear_layer/scene.toml",
                                       {"initial.velocity=10 m/s", "fluid.viscosity=1e-3 m2/s",
                                        "lattice.mach=0.9", "run.end=0.1 s"});
  auto const row = cases::measure(
      scene,
      {1.0 / 32, cases::Collision::bgk, lbm::WallRule::quadratic, cases::Precision::double_},
      {});
  EXPECT_TRUE(row.outcome.starts_with("Diverged at step")) << row.outcome;
  EXPECT_NE(cases::csv({row}).find(",bgk,quadratic,double,,,,error_l2,,0,\"Diverged at step"),
            std::string::npos)
      << cases::csv({row});
}

TEST(Chart, BadInputIsASentence)
{
  auto const none = velum_program("chart cases/closed_valve/scene.toml --out /tmp/velum-none");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(none.text,
            "cases/closed_valve/scene.toml: reference is missing; a chart needs an error to "
            "show.\n");
  auto const unknown = velum_program(
      "chart cases/lid_cavity/scene.toml --set 'fluid.viscosity=0.02 m2/s' --out /tmp/velum-none");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.text.find("has nothing for Re = 50"), std::string::npos) << unknown.text;
  EXPECT_EQ(velum_program("chart").exit_code, 2);
}

TEST(Limits, FindsALimitAndWritesIt)
{
  TemporaryFolder const out;
  auto const run =
      velum_program("limits shear_layer --quick --cells 16 --threads 1 --out " + out.path.string());
  ASSERT_EQ(run.exit_code, 0) << run.text;
  auto const table = read(out.path / "limits.csv");
  EXPECT_EQ(lines(table), 1 + 4 * 2 * 2) << table;
  EXPECT_NE(table.find("Diverged at step"), std::string::npos) << table;
}

// BGK gives up long before central moments do; both at 16 cells.
TEST(Limits, CentralMomentsOutliveBgk)
{
  auto const& map = cases::limit_maps().front();
  auto const limit = [&](cases::Collision collision) {
    return cases::largest_reynolds(map, {collision, false, 0.1, 0}, 16);
  };
  auto const bgk = limit(cases::Collision::bgk);
  EXPECT_EQ(bgk.bound, "found");
  EXPECT_NE(bgk.beyond.find("Diverged at step"), std::string::npos);
  EXPECT_GT(limit(cases::Collision::central_moments).reynolds, 100 * bgk.reynolds);
}

/// The numbers of one line of the table of contact_penalty, behind the method.
std::vector<double> penalty_row(std::string const& table, std::string const& start)
{
  auto const at = table.find("\n" + start);
  EXPECT_NE(at, std::string::npos) << start;
  std::istringstream line(table.substr(table.find(',', at) + 1));
  std::vector<double> numbers;
  char comma = ',';
  for (double number; comma == ',' && line >> number; line.get(comma)) numbers.push_back(number);
  return numbers;
}

// What presses by p goes p / k in; the multipliers take that back, for a few more solves.
TEST(Limits, ContactPenaltyShowsWhatEachMethodCosts)
{
  enum { stiffness, penetration, force, force_error, largest, largest_error, solves, linear };
  TemporaryFolder const out;
  auto const run = velum_program("limits contact_penalty --quick --cells 8 --threads 1 --out " +
                                 out.path.string());
  ASSERT_EQ(run.exit_code, 0) << run.text;
  auto const table = read(out.path / "penalty.csv");
  EXPECT_EQ(lines(table), 1 + 2 * 4) << table;
  double before = 0;
  for (std::string const k : {"1e+09", "1e+10", "1e+11", "1e+12"}) {
    auto const soft = penalty_row(table, "penalty," + k);
    auto const exact = penalty_row(table, "augmented_lagrangian," + k);
    ASSERT_EQ(soft.size(), 8u) << table;
    ASSERT_EQ(exact.size(), 8u) << table;
    if (before > 0) {
      EXPECT_NEAR(before / soft[penetration], 10, 1) << k;
    }
    before = soft[penetration];
    EXPECT_LT(exact[penetration], 1e-10) << k;
    EXPECT_LT(exact[force_error], 1e-6) << k;
    EXPECT_GT(soft[force_error], 10 * exact[force_error]) << k;
    EXPECT_GT(exact[linear], soft[linear]) << k;
  }
}

TEST(Limits, BadInputIsASentence)
{
  auto const outcome = velum_program("limits shear_leyer");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.text,
            "limits: shear_leyer is not a map; did you mean \"shear_layer\"? Maps: shear_layer, "
            "taylor_green, pressure_step or contact_penalty.\n");
  EXPECT_EQ(velum_program("limits shear_layer --cells 2").exit_code, 2);
}

}  // namespace
}  // namespace velum::tests
