#include "cases/app/limits.hpp"

#include "cases/app/csv_text.hpp"
#include "cases/app/derived.hpp"
#include "cases/app/fluid_run.hpp"
#include "cases/app/scene_words.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace velum::cases {
namespace {

/// The scene with the collision, the closure and the Mach number of a point.
Scene under(LimitPoint const& p, Scene scene)
{
  scene.lattice.mach = p.mach;
  scene.lattice.collision = p.collision;
  scene.les.model = p.les ? LesModel::smagorinsky : LesModel::off;
  return scene;
}

/// Minion & Brown's doubly periodic shear layer on the unit square with unit velocity, for five
/// unit times: after one it has rolled up; what grows slowly shows in the four that follow.
Scene shear_layer(LimitPoint const& p, int cells)
{
  Scene scene{.name = "shear_layer",
              .fidelity = Fidelity::planar,
              .lattice = {.dx = 1.0 / cells, .from = {0, 0}, .to = {1, 1}},
              .fluid = {.density = 1, .viscosity = 1 / p.reynolds},
              .run = {.settle = 5, .output_every = 5, .end = 5, .sample_every = 5}};
  scene.lattice.periodic = {true, true, false};
  scene.initial = {.kind = InitialKind::shear_layer, .velocity = 1};
  return under(p, scene);
}

/// The Taylor-Green vortex in a periodic box with unit velocity and side 2 pi, past its largest
/// dissipation: at high Reynolds numbers eddies far below a cell.
Scene vortices_in_space(LimitPoint const& p, int cells)
{
  double const side = 2 * std::numbers::pi;
  Scene scene{.name = "taylor_green",
              .fidelity = Fidelity::space,
              .lattice = {.dx = side / cells, .from = {0, 0, 0}, .to = {side, side, side}},
              .fluid = {.density = 1, .viscosity = 1 / p.reynolds},
              .run = {.settle = 12, .output_every = 12, .end = 12, .sample_every = 12}};
  bool const on_d3q19 = lbm::is_defined(p.collision, directions(Stencil::d3q19));
  scene.lattice.stencil = on_d3q19 ? Stencil::d3q19 : Stencil::d3q27;
  scene.lattice.periodic = {true, true, true};
  scene.initial = {.kind = InitialKind::taylor_green, .velocity = 1};
  return under(p, scene);
}

/// A channel of unit width at rest, its middle half blocked by a plate: at t = 0 the pressure of
/// Bernoulli's unit velocity stands at one end, and a jet forms beside the plate. Ten unit times.
Scene pressure_step(LimitPoint const& p, int cells)
{
  Scene scene{.name = "pressure_step",
              .fidelity = Fidelity::planar,
              .lattice = {.dx = 1.0 / cells, .from = {0, 0}, .to = {3, 1}},
              .fluid = {.density = 1, .viscosity = 1 / p.reynolds},
              .run = {.settle = 10, .output_every = 10, .end = 10, .sample_every = 10}};
  scene.solids = {
      {.name = "plate", .shape = SolidShape::box, .from = {1, 0.25}, .to = {1.25, 0.75}}};
  scene.boundaries = {{"inlet", BoundaryKind::pressure, constant(0.5), {{"x-", {0, 0}, {1, 0}}}},
                      {"outlet", BoundaryKind::outflow, constant(0), {{"x+", {0, 0}, {1, 0}}}}};
  return under(p, scene);
}

/// The sentence with which a flow diverges; nothing where it does not.
std::optional<std::string> divergence(LimitMap const& map, LimitPoint const& point, int cells)
{
  try {
    march_fluid(map.scene(point, cells), {.out = {}, .quiet = true});
    return {};
  } catch (core::Divergence const& lost) {
    return lost.what();
  }
}

/// Bisects one number of the point between two bounds.
/// @param middle  of two numbers
/// @param near    whether two numbers are near enough
LimitRow bisect(LimitMap const& map, LimitPoint point, int cells, double LimitPoint::*number,
                double least, double most, double (*middle)(double, double),
                bool (*near)(double, double))
{
  LimitRow row{point.collision, point.les, "", point.mach, point.reynolds, 0, "found", ""};
  auto const lost_at = [&](double value) {
    point.*number = value;
    return divergence(map, point, cells);
  };
  double stable = least, lost = most;
  if (auto const at_least = lost_at(least)) {
    row.bound = "all";
    row.beyond = *at_least;
  } else if (auto at_most = lost_at(most)) {
    row.beyond = *at_most;
    while (!near(stable, lost)) {
      double const between = middle(stable, lost);
      if (auto const sentence = lost_at(between)) {
        lost = between;
        row.beyond = *sentence;
      } else {
        stable = between;
      }
    }
  } else {
    row.bound = "none";
    stable = most;
  }
  point.*number = stable;
  row.mach = point.mach;
  row.reynolds = point.reynolds;
  row.tau_minus_half = derive(map.scene(point, cells)).tau_minus_half;
  return row;
}

}  // namespace

std::vector<LimitMap> const& limit_maps()
{
  static std::vector<LimitMap> const maps = {
      {"shear_layer", "doubly periodic shear layer, steepness 80, five unit times", shear_layer,
       64},
      {"taylor_green", "Taylor-Green vortex in space, d3q19 (cumulant: d3q27), to t U/L = 12",
       vortices_in_space, 32},
      {"pressure_step", "pressure step on a half blocked channel at rest, ten unit times",
       pressure_step, 64}};
  return maps;
}

LimitRow largest_reynolds(LimitMap const& map, LimitPoint point, int cells)
{
  auto row = bisect(
      map, point, cells, &LimitPoint::reynolds, least_reynolds, most_reynolds,
      [](double a, double b) { return std::sqrt(a * b); },
      [](double a, double b) { return b < a * std::pow(10, 0.125); });
  row.quantity = "reynolds";
  return row;
}

LimitRow largest_mach(LimitMap const& map, LimitPoint point, int cells)
{
  auto row = bisect(
      map, point, cells, &LimitPoint::mach, least_mach, most_mach,
      [](double a, double b) { return (a + b) / 2; },
      [](double a, double b) { return b < 1.02 * a; });
  row.quantity = "mach";
  return row;
}

std::string csv(std::string const& map, int cells, std::vector<LimitRow> const& rows)
{
  std::string text = "map,cells,collision,les,quantity,mach,reynolds,tau_minus_half,bound,beyond\n";
  for (auto const& r : rows)
    text += fmt::format("{},{},{},{},{},{:.4g},{:.4g},{:.4g},{},{}\n", map, cells,
                        word(r.collision), r.les ? "smagorinsky" : "off", r.quantity, r.mach,
                        r.reynolds, r.tau_minus_half, r.bound, csv_cell(r.beyond));
  return text;
}

}  // namespace velum::cases
