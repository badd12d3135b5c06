#include "cases/app/chart.hpp"

#include "cases/app/coupled_run.hpp"
#include "cases/app/csv_text.hpp"
#include "cases/app/fluid_run.hpp"
#include "cases/app/reference.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace velum::cases {
namespace {

double figure(core::Summary const& summary, std::string const& name)
{
  auto const found = std::find_if(summary.figures.begin(), summary.figures.end(),
                                  [&](core::Figure const& f) { return f.name == name; });
  core::require(
      found != summary.figures.end(),
      fmt::format("The run has no figure {}: either reference.figure is none of its summary, "
                  "or it ends too early to know it.",
                  name));
  return found->value;
}

core::Summary run_in(std::filesystem::path const& folder, Scene const& scene)
{
  std::filesystem::create_directories(folder);
  run_coupled(scene, {.out = folder, .quiet = true});
  return core::read_summary(folder / "summary.json");
}

}  // namespace

std::vector<ChartPoint> chart_points(Scene const& scene, bool quick)
{
  auto dx = scene.chart.dx;
  if (dx.empty()) dx = {2 * scene.lattice.dx, scene.lattice.dx};
  std::sort(dx.begin(), dx.end(), std::greater<>());
  if (quick && dx.size() > 1) dx.pop_back();
  std::vector<ChartPoint> points;
  for (double const cell : dx)
    for (auto const& [collision_name, collision] : words(Collision{}))
      for (auto const& [rule_name, rule] : words(lbm::WallRule{}))
        for (auto const& [precision_name, precision] : words(Precision{})) {
          if (!lbm::is_defined(collision, rule)) continue;
          bool const usual =
              rule == (lbm::is_defined(collision, scene.lattice.wall_rule) ? scene.lattice.wall_rule
                                                                           : lbm::WallRule::linear);
          if (!usual && (scene.solids.empty() || precision != Precision::double_)) continue;
          if (scene.membrane && precision == Precision::half) continue;
          if (lbm::is_defined(collision, directions(scene.lattice.stencil)))
            points.push_back({cell, collision, rule, precision});
        }
  return points;
}

ChartRow measure(Scene const& scene, ChartPoint const& point, std::filesystem::path const& folder)
{
  Scene variant = scene;
  variant.lattice.dx = point.dx;
  variant.lattice.collision = point.collision;
  variant.lattice.wall_rule = point.wall_rule;
  variant.lattice.precision = point.precision;
  bool const same = point.dx == scene.lattice.dx && point.collision == scene.lattice.collision &&
                    point.wall_rule == scene.lattice.wall_rule &&
                    point.precision == scene.lattice.precision;
  ChartRow row{scene.name, point.dx, point.collision, point.wall_rule, point.precision, same};
  row.error_key = error_key(variant, load_reference(variant));
  try {
    auto const summary = variant.membrane ? run_in(folder, variant)
                                          : march_fluid(variant, {.out = {}, .quiet = true});
    row.steps = figure(summary, "steps");
    row.wall_time = figure(summary, "wall_time");
    row.mlups = figure(summary, "mlups");
    row.error = figure(summary, row.error_key);
  } catch (core::Divergence const& divergence) {
    row.outcome = divergence.what();
  }
  return row;
}

std::string csv(std::vector<ChartRow> const& rows)
{
  std::string text =
      "scene,dx [m],collision,wall_rule,precision,steps,wall_time [s],mlups "
      "[1e6/s],error_key,error,default,"
      "outcome\n";
  for (auto const& r : rows) {
    bool const ok = r.outcome == "ok";
    text += fmt::format(
        "{},{:.9g},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(r.scene), r.dx, word(r.collision),
        word(r.wall_rule), word(r.precision), ok ? fmt::format("{:.0f}", r.steps) : "",
        ok ? fmt::format("{:.4g}", r.wall_time) : "", ok ? fmt::format("{:.4g}", r.mlups) : "",
        r.error_key, ok ? fmt::format("{:.6g}", r.error) : "", r.is_default ? 1 : 0,
        csv_cell(r.outcome));
  }
  return text;
}

}  // namespace velum::cases
