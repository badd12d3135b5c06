#include "cases/app/sweep.hpp"

#include "cases/app/csv_text.hpp"
#include "core/check.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace velum::cases {
namespace {

/// What a valve is swept for; names of cases/app/valve_text.cpp and chatter_text.cpp.
constexpr char const* of_valves[] = {"valve_flow_final", "valve_gap_final",
                                     "valve_chamber_pressure_final", "chatter_frequency",
                                     "chatter_amplitude"};
/// What a computation cost, which differs from run to run and says nothing of the case.
constexpr char const* costs[] = {"wall_time", "mlups", "membrane_share", "iterations", "steps"};
constexpr std::size_t most_chosen = 4;

bool is_cost(std::string const& name)
{
  return std::find(std::begin(costs), std::end(costs), name) != std::end(costs);
}

std::string header(core::Figure const& figure)
{
  return fmt::format("{} [{}]", figure.name, figure.unit);
}

/// What each figure is called by `name_of`, each once, as they first come up in the runs.
template <class NameOf>
std::vector<std::string> names_of(std::vector<SweepRun> const& runs, NameOf const& name_of)
{
  std::vector<std::string> names;
  for (auto const& run : runs)
    for (auto const& figure : run.figures)
      if (auto name = name_of(figure); std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(std::move(name));
  return names;
}

std::vector<std::string> figure_names(std::vector<SweepRun> const& runs)
{
  return names_of(runs, [](core::Figure const& figure) { return figure.name; });
}

core::Figure const* find_figure(SweepRun const& run, std::string const& name)
{
  auto const found = std::find_if(run.figures.begin(), run.figures.end(),
                                  [&](core::Figure const& f) { return f.name == name; });
  return found == run.figures.end() ? nullptr : &*found;
}

bool differs(std::vector<SweepRun> const& runs, std::string const& name)
{
  std::optional<double> first;
  for (auto const& run : runs) {
    auto const* figure = find_figure(run, name);
    if (!figure || std::isnan(figure->value)) continue;
    if (first && *first != figure->value) return true;
    first = figure->value;
  }
  return false;
}

/// A figure in a unit that is read easily.
std::string readable(core::Figure const& figure)
{
  struct Unit {
    char const* si;
    double per_si;
    char const* unit;
  };
  bool const small = std::abs(figure.value) < 1e-3;
  Unit const units[] = {{"m3/s", 3.6e6, "l/h"},
                        {"Pa", 1e-3, "kPa"},
                        {"m", small ? 1e6 : 1e3, small ? "um" : "mm"},
                        {"s", 1e3, "ms"},
                        {"1", 1, ""}};
  Unit chosen{"", 1, figure.unit.c_str()};
  for (auto const& unit : units)
    if (figure.unit == unit.si) chosen = unit;
  return fmt::format("{} {:.4g}{}{}", figure.name, chosen.per_si * figure.value,
                     *chosen.unit ? " " : "", chosen.unit);
}

}  // namespace

std::string csv(std::vector<SweepAxis> const& axes, std::vector<SweepRun> const& runs)
{
  auto const columns = names_of(runs, header);
  std::string text;
  for (auto const& axis : axes) text += csv_cell(axis.key) + ',';
  text += "outcome";
  for (auto const& column : columns) text += ',' + csv_cell(column);
  text += '\n';
  for (auto const& run : runs) {
    if (run.outcome.empty()) continue;
    for (auto const& value : run.values) text += csv_cell(value) + ',';
    text += csv_cell(run.outcome);
    for (auto const& column : columns) {
      auto const found =
          std::find_if(run.figures.begin(), run.figures.end(),
                       [&](core::Figure const& figure) { return header(figure) == column; });
      text += found == run.figures.end() ? "," : fmt::format(",{}", found->value);
    }
    text += '\n';
  }
  return text;
}

std::vector<std::string> shown_figures(std::vector<SweepRun> const& runs,
                                       std::vector<std::string> const& asked)
{
  if (!asked.empty()) return asked;
  auto const names = figure_names(runs);
  auto const has = [&](std::string const& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<std::string> shown;
  if (has(of_valves[0])) {
    std::copy_if(std::begin(of_valves), std::end(of_valves), std::back_inserter(shown), has);
    return shown;
  }
  for (bool const all : {false, true}) {  // all, where none differs
    for (auto const& name : names)
      if (shown.size() < most_chosen && !is_cost(name) && (all || differs(runs, name)))
        shown.push_back(name);
    if (!shown.empty()) break;
  }
  return shown;
}

void check_shown(std::vector<SweepRun> const& runs, std::vector<std::string> const& asked)
{
  auto const names = figure_names(runs);
  if (names.empty()) return;
  for (auto const& name : asked) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    auto const near = core::nearest(name, names);
    throw core::InputError(fmt::format("--show: no run has a figure {}{}", name,
                                       near.empty()
                                           ? "; the head of sweep.csv names those that there are."
                                           : fmt::format("; did you mean \"{}\"?", near)));
  }
}

std::string run_text(std::vector<SweepAxis> const& axes, SweepRun const& run,
                     std::vector<std::string> const& shown)
{
  std::string text;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    std::size_t width = 0;
    for (auto const& value : axes[a].values) width = std::max(width, value.size());
    text += fmt::format("{:<{}}  ", run.values[a], width);
  }
  if (run.outcome != "ok") return text + run.outcome;
  std::string separator;
  for (auto const& name : shown)
    if (auto const* figure = find_figure(run, name)) {
      text += separator + readable(*figure);
      separator = ", ";
    }
  return text;
}

}  // namespace velum::cases
