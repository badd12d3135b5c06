#pragma once
#include <string>
#include <vector>

#include "cases/app/history.hpp"
#include "cases/app/material_range.hpp"
#include "cases/app/scene.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// What the history does not tell.
struct ValveSeen {
  double seat_diameter = 0;  // m; 0: unknown
  StretchRecord stretch{};
};

/// What a run of a valve says at its end.
struct ValveReport {
  std::vector<core::Figure> figures;  // of valve_figures.hpp and chatter.hpp
  core::Assumptions rules;            // by which they were read, for the summary's assumptions
  std::string text;
  std::string kv;  // Kv over lift as a file; empty where the valve stays shut
};

/// Figures and chatter of a valve scene's history, whole or as far as it came.
/// @pre the history has the columns gap, flow, pressure_above, pressure_outside, pressure_inside,
///      and two rows
ValveReport valve_report(Scene const& scene, History const& history, ValveSeen const& seen = {});

}  // namespace velum::cases
