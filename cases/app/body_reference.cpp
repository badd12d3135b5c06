#include "cases/app/body_run.hpp"
#include "cases/app/table_file.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velum::cases {
namespace {

double bending_stiffness(BodyScene const& scene)
{
  double const H = largest_magnitude(scene.body.thickness);
  return structure::shear_modulus(material(scene).rubber) * H * H * H / 3;
}

/// mu H a
double unit_force(BodyScene const& scene)
{
  return structure::shear_modulus(material(scene).rubber) *
         largest_magnitude(scene.body.thickness) * span(scene.body);
}

}  // namespace

BodyTable load_body_table(BodyScene const& scene)
{
  auto const file = std::filesystem::path(scene.source.file).parent_path() / scene.reference->file;
  auto const table = read_table_file(file, {"load", "deflection"});
  BodyTable read;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto const load = number(table, row, "load"), deflection = number(table, row, "deflection");
    core::require(load && deflection && *load > 0 && *deflection != 0,
                  fmt::format("{}:{}: needs a load and a deflection above 0.", file.string(),
                              table.lines[row]));
    read.load.push_back(*load);
    read.deflection.push_back(*deflection);
    read.force.push_back(number(table, row, "force"));
  }
  return read;
}

double load_of(BodyScene const& scene, BodyState const& state)
{
  double const a = span(scene.body), H = largest_magnitude(scene.body.thickness);
  return scene.reference->scale == LoadScale::plate
             ? state.pressure * std::pow(a, 4) / (64 * bending_stiffness(scene) * H)
             : state.pressure * a / (structure::shear_modulus(material(scene).rubber) * H);
}

double unit_deflection(BodyScene const& scene)
{
  return scene.reference->scale == LoadScale::plate ? largest_magnitude(scene.body.thickness)
                                                    : span(scene.body);
}

std::optional<std::size_t> row_of(BodyScene const& scene, BodyTable const& table,
                                  BodyState const& state)
{
  double const load = load_of(scene, state);
  for (std::size_t k = 0; k < table.load.size(); ++k)
    if (std::abs(load / table.load[k] - 1) < 1e-6) return k;
  return {};
}

std::vector<core::Figure> compare(BodyScene const& scene, BodyTable const& table,
                                  BodyResult const& result)
{
  auto const& reference = *scene.reference;
  std::vector<core::Figure> figures;
  double last = std::nan(""), largest = 0, limit = 0, force = std::nan("");
  int compared = 0;
  for (auto const& state : result.states) {
    limit = std::max(limit, load_of(scene, state));
    auto const row = row_of(scene, table, state);
    if (!row) continue;
    last = std::abs(state.deflection) / (table.deflection[*row] * unit_deflection(scene)) - 1;
    largest = std::max(largest, std::abs(last));
    if (auto const wanted = table.force[*row])
      force = state.force / (*wanted * unit_force(scene)) - 1;
    ++compared;
  }
  if (compared > 0) {
    figures.push_back({"pole_deflection_error", last, "1"});
    figures.push_back({"pole_deflection_error_max", largest, "1"});
    if (!std::isnan(force)) figures.push_back({"seat_force_error", force, "1"});
  }
  figures.push_back({"states_compared", double(compared), "1"});
  if (reference.limit_load) {
    figures.push_back({"limit_load", limit, "1"});
    figures.push_back({"limit_load_error", limit / *reference.limit_load - 1, "1"});
  }
  double const H = largest_magnitude(scene.body.thickness), a = span(scene.body);
  double const per_omega =
      a * a * std::sqrt(material(scene).density * H / bending_stiffness(scene));
  for (std::size_t k = 0; k < reference.frequencies.size(); ++k)
    figures.push_back(
        {fmt::format("frequency_{}_error", k + 1),
         2 * std::numbers::pi * result.frequencies[k] * per_omega / reference.frequencies[k] - 1,
         "1"});
  return figures;
}

}  // namespace velum::cases
