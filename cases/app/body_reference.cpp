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
  }
  return read;
}

Vec2 dimensionless(BodyScene const& scene, BodyState const& state)
{
  double const a = span(scene.body), H = largest_magnitude(scene.body.thickness);
  if (scene.reference->scale == LoadScale::plate)
    return {state.pressure * std::pow(a, 4) / (64 * bending_stiffness(scene) * H),
            state.deflection / H};
  return {state.pressure * a / (structure::shear_modulus(material(scene).rubber) * H),
          state.deflection / a};
}

std::optional<double> deflection_error(BodyScene const& scene, BodyTable const& table,
                                       BodyState const& state)
{
  auto const [load, deflection] = dimensionless(scene, state).c;
  for (std::size_t k = 0; k < table.load.size(); ++k)
    if (std::abs(load / table.load[k] - 1) < 1e-6)
      return std::abs(deflection) / table.deflection[k] - 1;
  return {};
}

std::vector<core::Figure> compare(BodyScene const& scene, BodyTable const& table,
                                  BodyResult const& result)
{
  auto const& reference = *scene.reference;
  std::vector<core::Figure> figures;
  double last = std::nan(""), largest = 0, limit = 0;
  int compared = 0;
  for (auto const& state : result.states) {
    limit = std::max(limit, dimensionless(scene, state)[0]);
    auto const error = deflection_error(scene, table, state);
    if (!error) continue;
    last = *error;
    largest = std::max(largest, std::abs(last));
    ++compared;
  }
  if (compared > 0) {
    figures.push_back({"pole_deflection_error", last, "1"});
    figures.push_back({"pole_deflection_error_max", largest, "1"});
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
