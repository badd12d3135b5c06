#include "cases/app/body_run.hpp"

#include "cases/app/body_march.hpp"
#include "cases/app/body_model.hpp"
#include "cases/app/body_output.hpp"
#include "cases/app/material_range.hpp"
#include "core/check.hpp"
#include "structure/mesh_quality.hpp"
#include "structure/modes.hpp"
#include "structure/static_solve.hpp"
#include "structure/volume_control.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <numbers>

namespace velum::cases {
namespace {

constexpr int largest_updates = 200;        // of the multipliers
constexpr double multiplier_change = 1e-5;  // of the largest, at which they stand still

template <class Body>
int find_pressed_state(BodyScene const& scene, BodyModel<Body>& model, double pressure)
{
  model.set_pressure(scene.load.side, pressure);
  int iterations = structure::static_solve(model.body, model.loads).iterations;
  if (!scene.contact || scene.contact->method == ContactMethod::penalty) return iterations;
  for (int n = 0; n < largest_updates; ++n) {
    if (update_multipliers(model) <= multiplier_change * seat_figures(model).pressure_max)
      return iterations;
    iterations += structure::static_solve(model.body, model.loads).iterations;
  }
  throw core::Divergence(fmt::format(
      "the contact's multipliers still change after {} updates; a larger contact.stiffness than "
      "{:.3g} Pa/m makes them settle sooner",
      largest_updates, penalty(scene)));
}

/// Says which state failed.
template <class Solve>
auto at_state(std::size_t k, std::string const& what, Solve const& solve)
{
  try {
    return solve();
  } catch (core::Divergence const& failure) {
    throw core::Divergence(fmt::format("State {}, {}: {}", k + 1, what, failure.what()));
  }
}

template <class Body>
BodyResult solve(BodyScene const& scene, BodyModel<Body>& model, BodyTable const& table,
                 BodyOutput& out, StretchRecord& stretch)
{
  BodyResult result;
  auto const inflation = structure::inflation(model.body);
  auto const note = [&](double pressure, int iterations) {
    BodyState state = state_of(scene, model, pressure, iterations, stretch);
    if (auto const row = scene.reference ? row_of(scene, table, state) : std::nullopt)
      state.reference =
          std::copysign(table.deflection[*row] * unit_deflection(scene), state.deflection);
    result.states.push_back(state);
    record(out, model, state, int(result.states.size()));
    spdlog::info("state {}: pressure {:.6g} Pa, volume {:.6g} mm3, deflection {:.6g} mm",
                 result.states.size(), pressure, 1e9 * state.volume, 1e3 * state.deflection);
  };
  if (scene.modes > 0) {
    auto const modes = structure::slowest_modes(model.body, model.loads, scene.modes);
    for (double omega : modes.omega) result.frequencies.push_back(omega / (2 * std::numbers::pi));
  }
  for (double pressure : scene.load.pressures)
    note(pressure, at_state(result.states.size(), fmt::format("pressure {:.6g} Pa", pressure),
                            [&] { return find_pressed_state(scene, model, pressure); }));
  for (double volume : scene.load.volumes) {
    double const before = result.states.back().pressure;
    auto const report =
        at_state(result.states.size(), fmt::format("volume {:.6g} mm3", 1e9 * volume), [&] {
          return structure::solve_at_volume(
              model.body, inflation, volume + inflation.volume(model.body.reference), before);
        });
    note(report.pressure, report.iterations);
  }
  return result;
}

core::Summary summary_of(BodyScene const& scene, BodyResult const& result, BodyTable const& table,
                         double wall_time)
{
  auto const& last =
      scene.march ? result.states.back() : result.states[scene.load.pressures.size() - 1];
  bool const disc = scene.body.shape == BodyShape::disc;
  core::Summary summary{{{disc ? "pole_deflection" : "deflection_max", last.deflection, "m"},
                         {"pressure", last.pressure, "Pa"},
                         {"volume", last.volume, "m3"},
                         {"stretch_max", last.stretch_max, "1"}},
                        body_assumptions(scene)};
  auto& figures = summary.figures;
  if (scene.contact) {
    figures.push_back({"seat_force", last.force, "N"});
    figures.push_back({"contact_area", last.area, "m2"});
    figures.push_back({"contact_pressure_max", last.pressure_max, "Pa"});
    figures.push_back({"penetration", last.penetration, "m"});
  }
  if (scene.contact && scene.march) {
    figures.push_back({"seat_force_max", result.seat_force_max, "N"});
    figures.push_back({"penetration_max", result.penetration_max, "m"});
  }
  for (std::size_t k = 0; k < result.frequencies.size(); ++k)
    figures.push_back({fmt::format("frequency_{}", k + 1), result.frequencies[k], "Hz"});
  int iterations = 0;
  for (auto const& state : result.states) iterations += state.iterations;
  figures.push_back({"iterations", double(iterations), "1"});
  figures.push_back({"wall_time", wall_time, "s"});
  if (scene.reference)
    for (auto const& figure : compare(scene, table, result)) figures.push_back(figure);
  return summary;
}

template <class Body>
void run_as(BodyScene const& scene, std::filesystem::path const& folder)
{
  auto const start = std::chrono::steady_clock::now();
  BodyTable const table = scene.reference ? load_body_table(scene) : BodyTable{};
  for (auto const& [name, sentence] : body_assumptions(scene))
    spdlog::info("{}: {}", name, sentence);
  if (scene.body.shape == BodyShape::mesh)
    for (auto const& sentence : structure::warnings(structure::mesh_quality(scene.body.mesh.mesh)))
      spdlog::warn("{}: {}", scene.body.file, sentence);
  BodyModel<Body> model(scene);
  auto out = start_output(scene, folder);
  StretchRecord stretch;
  std::string scheme;
  auto const result = scene.march ? march(scene, model, out, stretch, scheme)
                                  : solve(scene, model, table, out, stretch);
  double const wall_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  auto summary = summary_of(scene, result, table, wall_time);
  if (scene.march) summary.assumptions["scheme"] = scheme;
  add_range(summary.assumptions, stretch, material(scene));
  core::write_summary(folder / "summary.json", summary);
  for (auto const& figure : summary.figures)
    spdlog::info("{} = {:.6g}{}", figure.name, figure.value,
                 figure.unit == "1" ? "" : " " + figure.unit);
  spdlog::info("results: {}", (folder / "run.xmf").string());
}

}  // namespace

void run_body(BodyScene const& scene, std::filesystem::path const& out)
{
  if (scene.body.elements == Elements::lines)
    run_as<structure::Membrane>(scene, out);
  else
    run_as<structure::Sheet>(scene, out);
}

}  // namespace velum::cases
