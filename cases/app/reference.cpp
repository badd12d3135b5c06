#include "cases/app/reference.hpp"

#include "cases/app/derived.hpp"
#include "cases/app/table_file.hpp"
#include "core/spelling.hpp"

#include <spdlog/spdlog.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

namespace velum::cases {
namespace {

/// Whether a row belongs to the value of the run; a table without the column holds for all.
bool matches(std::optional<double> given, double wanted, double tolerance)
{
  return !given || std::abs(*given - wanted) <= tolerance * std::abs(wanted);
}

ReferenceData load_exact(Scene const& scene)
{
  auto const& reference = *scene.reference;
  if (reference.kind == ReferenceKind::figure)
    return {
        {}, {}, fmt::format("{} = {:.6g}, as the scene has it", reference.figure, reference.value)};
  return {{},
          {},
          scene.reference->kind == ReferenceKind::pipe
              ? "Hagen-Poiseuille flow, u = g (R^2 - r^2) / 4 nu"
              : "exact decay of the Taylor-Green vortex"};
}

}  // namespace

ReferenceData load_reference(Scene const& scene)
{
  auto const& reference = *scene.reference;
  if (reference.file.empty()) return load_exact(scene);
  bool const body =
      reference.kind == ReferenceKind::body || reference.kind == ReferenceKind::dissipation;
  auto const table =
      read_table_file(std::filesystem::path(scene.source.file).parent_path() / reference.file,
                      body ? std::vector<std::string>{"figure", "low", "high"}
                           : std::vector<std::string>{"x", "y", "u", "v"});
  double const L = reference.length, U = flow_velocity(scene);
  double const reynolds = U * L / scene.fluid.viscosity, end = scene.run.end * U / L;

  ReferenceData data;
  std::set<double> others;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto const given = number(table, row, "reynolds");
    if (!matches(given, reynolds, 1e-6)) {
      others.insert(*given);
      continue;
    }
    if (!matches(number(table, row, "time"), end, 1e-3)) continue;
    if (body) {
      data.bounds.push_back({text(table, row, "figure"), number(table, row, "low").value_or(0),
                             number(table, row, "high").value_or(0)});
      continue;
    }
    auto const scaled = [&](std::string const& column) {
      auto value = number(table, row, column);
      if (value) *value *= U;
      return value;
    };
    data.points.push_back(
        {{L * number(table, row, "x").value_or(0), L * number(table, row, "y").value_or(0),
          L * number(table, row, "z").value_or(0)},
         scaled("u"),
         scaled("v"),
         scaled("w")});
  }
  if (!data.points.empty() || !data.bounds.empty())
    data.note = fmt::format("{} for Re = {:.6g}", reference.file, reynolds);
  else if (others.empty())
    data.note = fmt::format("none: {} has nothing for the end of this run", reference.file);
  else
    data.note =
        fmt::format("none: {} has nothing for Re = {:.6g} at the end of this run, only for {}",
                    reference.file, reynolds, fmt::join(others, ", "));
  return data;
}

std::vector<core::Figure> compare(ReferenceData const& data, Result const& result)
{
  switch (result.scene.reference->kind) {
    case ReferenceKind::points:
      return compare_points(data, result);
    case ReferenceKind::taylor_green:
      return compare_taylor_green(result);
    case ReferenceKind::pipe:
      return compare_pipe(result);
    case ReferenceKind::body:
      return compare_body(data, result);
    case ReferenceKind::dissipation:
      return compare_dissipation(data, result);
    case ReferenceKind::figure:
      break;  // of the whole summary: compare_figure()
  }
  return {};
}

void compare_figure(Scene const& scene, core::Summary& summary)
{
  if (!scene.reference || scene.reference->kind != ReferenceKind::figure) return;
  auto const& reference = *scene.reference;
  auto& figures = summary.figures;
  auto const found = std::find_if(figures.begin(), figures.end(), [&](core::Figure const& f) {
    return f.name == reference.figure;
  });
  if (found != figures.end()) {
    double const error = std::abs(found->value - reference.value) / reference.scale;
    figures.push_back({reference.figure + "_error", error, "1"});
    return;
  }
  std::vector<std::string> names;
  for (auto const& f : figures) names.push_back(f.name);
  std::string const near = core::nearest(reference.figure, names);
  summary.assumptions["reference"] = fmt::format(
      "none: this run has no figure {}{} Some want a longer run. It has: {}", reference.figure,
      near.empty() ? "." : fmt::format("; did you mean {}?", near), fmt::join(names, ", "));
  spdlog::warn("reference: {}", summary.assumptions["reference"]);
}

std::string error_key(Scene const& scene, ReferenceData const& data)
{
  if (scene.reference->kind == ReferenceKind::figure) return scene.reference->figure + "_error";
  if (scene.reference->file.empty() || !data.points.empty()) return "error_l2";
  return data.bounds.empty() ? "" : data.bounds.front().figure + "_error";
}

std::vector<core::Figure> errors_of(ReferenceData const& data,
                                    std::vector<core::Figure> const& figures)
{
  std::vector<core::Figure> errors;
  for (auto const& bound : data.bounds) {
    auto const found = std::find_if(figures.begin(), figures.end(),
                                    [&](core::Figure const& f) { return f.name == bound.figure; });
    if (found == figures.end()) continue;
    double const middle = (bound.low + bound.high) / 2;
    errors.push_back({bound.figure + "_error", std::abs(found->value / middle - 1), "1"});
    errors.push_back({bound.figure + "_within",
                      double(found->value >= bound.low && found->value <= bound.high), "1"});
  }
  return errors;
}

std::vector<core::Figure> compare_points(ReferenceData const& data, Result const& result)
{
  double squared = 0, whole = 0, worst = 0;
  int values = 0;
  auto const add = [&](std::optional<double> const& wanted, double lattice_velocity) {
    if (!wanted) return;
    double const off = core::to_si_velocity(result.units, lattice_velocity) - *wanted;
    squared += off * off;
    whole += *wanted * *wanted;
    worst = std::max(worst, std::abs(off));
    ++values;
  };
  for (auto const& point : data.points) {
    auto const state = state_at(result.flow, point.at);
    add(point.u, state.ux);
    add(point.v, state.uy);
    add(point.w, state.uz);
  }
  if (values == 0) return {};
  return {{"error_l2", std::sqrt(squared / whole), "1"},
          {"error_max", worst / flow_velocity(result.scene), "1"},
          {"reference_values", double(values), "1"}};
}

}  // namespace velum::cases
