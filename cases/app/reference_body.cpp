#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/app/derived.hpp"
#include "cases/app/oscillation.hpp"
#include "cases/app/reference.hpp"

namespace velum::cases {
namespace {

/// Lift below this share of the drag is noise, not shedding.
constexpr double noise = 2e-3;

void add_coefficients(Result const& r, std::vector<core::Figure>& figures)
{
  auto const& reference = *r.scene.reference;
  double const L = reference.length, U = flow_velocity(r.scene);
  double const area =
      symmetry(r.scene) == core::Symmetry::planar ? L : std::numbers::pi * L * L / 4;
  double const scale = 2 / (r.scene.fluid.density * U * U * area);
  auto const& time = r.history.time;
  auto drag = r.history.column(reference.force + "_force_x");
  auto lift = r.history.column(reference.force + "_force_y");
  for (double& c : drag) c *= scale;
  for (double& c : lift) c *= scale;
  std::vector<double> difference;
  if (!reference.difference.empty())
    difference = r.history.column(reference.difference + "_pressure_difference");

  auto const shedding = last_periods(time, lift, noise * std::abs(drag.back()));
  if (!shedding) {
    figures.push_back({"drag_coefficient", drag.back(), "1"});
    figures.push_back({"lift_coefficient", lift.back(), "1"});
    if (!difference.empty()) figures.push_back({"pressure_difference", difference.back(), "Pa"});
    return;
  }
  double const begin = shedding->begin, end = shedding->end;
  figures.push_back({"drag_coefficient", mean(time, drag, begin, end), "1"});
  figures.push_back({"drag_coefficient_max", largest(time, drag, begin, end), "1"});
  figures.push_back({"lift_coefficient_max", largest(time, lift, begin, end), "1"});
  figures.push_back({"strouhal", L / (U * shedding->period), "1"});
  if (!difference.empty())
    figures.push_back({"pressure_difference",
                       at_time(time, difference, shedding->top + shedding->period / 2), "Pa"});
}

}  // namespace

std::vector<core::Figure> compare_body(ReferenceData const& data, Result const& r)
{
  std::vector<core::Figure> figures;
  add_coefficients(r, figures);
  auto const errors = errors_of(data, figures);
  figures.insert(figures.end(), errors.begin(), errors.end());
  return figures;
}

}  // namespace velum::cases
