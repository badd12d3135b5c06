#pragma once
#include <string>
#include <vector>

#include "cases/app/history.hpp"
#include "cases/app/scene.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// What a run of a valve says at its end.
struct ValveReport {
  std::vector<core::Figure> figures;  // of valve_figures.hpp and chatter.hpp
  core::Assumptions rules;            // by which they were read, for the summary's assumptions
  std::string text;
};

/// Figures and chatter of a valve scene's history, whole or as far as it came.
/// @param seat_diameter  m; 0: unknown
/// @pre the history has the columns gap, flow, pressure_above, pressure_outside, pressure_inside,
///      and two rows
ValveReport valve_report(Scene const& scene, History const& history, double seat_diameter = 0);

}  // namespace velum::cases
