#include "cases/app/chart.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/picture.hpp"
#include "cases/app/reference.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"

#include <fmt/format.h>

namespace velum::cases {
namespace {

/// A scene that can be charted: a flow with a reference for its Reynolds number.
Scene read_charted(std::filesystem::path const& file, std::vector<std::string> const& set)
{
  Scene scene = read_scene(file, set);
  core::require(
      scene.reference.has_value(),
      fmt::format("{}: reference is missing; a chart needs an error to show.", file.string()));
  auto const data = load_reference(scene);
  core::require(!error_key(scene, data).empty(),
                fmt::format("{}: a chart needs an error to show; the reference is {}.",
                            file.string(), data.note));
  return scene;
}

void print(ChartRow const& row)
{
  fmt::print("{:<18} {:>8.4g} mm  {:<21} {:<12} {:<7} {}\n", row.scene, 1e3 * row.dx,
             word(row.collision), word(row.wall_rule), word(row.precision),
             row.outcome == "ok"
                 ? fmt::format("{:>9.2f} s  {} = {:.3e}{}", row.wall_time, row.error_key, row.error,
                               row.is_default ? "  (default)" : "")
                 : row.outcome);
}

}  // namespace

void chart_command(Options const& options)
{
  auto const out = core::make_folder(
      options.out.empty() ? std::filesystem::path("results") / "chart" : options.out);
  std::vector<Scene> scenes;  // all are read first: bad input is said before anything is computed
  for (auto const& file : options.scenes) scenes.push_back(read_charted(file, options.set));
  catch_stop_signals();
  std::vector<ChartRow> rows;
  for (auto const& scene : scenes)
    for (auto const& point : chart_points(scene, options.quick)) {
      rows.push_back(measure(scene, point, out / "run"));
      core::write_atomically(out / "chart.csv", csv(rows));
      if (!options.quiet) print(rows.back());
      std::fflush(stdout);
    }
  fmt::print("{}\n", (out / "chart.csv").string());
  draw("chart.py", out);
}

}  // namespace velum::cases
