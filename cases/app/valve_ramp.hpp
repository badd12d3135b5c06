#pragma once
#include <string>
#include <vector>

#include "cases/app/valve_figures.hpp"

/// What a rise and a fall of the pressure difference tell of a valve whose pilot stays as it is.
namespace velum::cases {

/// Differences of the pressures of inlet and outlet, Pa; not a number where the history has none.
struct ValveRamp {
  double cracks = unknown;   // at which the gap first exceeds seals_at while the difference rises
  double reseats = unknown;  // at which it last comes back to that while the difference falls
  double hysteresis = unknown;  // cracks - reseats
};

/// Kv over lift, in one class of gaps; not a number where there was none.
struct KvClass {
  double gap;               // m, middle of the class
  double opening, closing;  // m3/h at 1 bar, the pilot's share in it; gap growing, shrinking
};

/// Reads the ramp off a history; a valve that opens or shuts at a steady difference is none.
/// @pre as for valve_sheet()
ValveRamp valve_ramp(History const& history, ValveFacts const& facts);

/// Kv of the samples between seals_at and the largest gap, in so many classes of equal width; empty
/// where the valve does not open. A sample counts as opening or closing by how the gap changes over
/// a hundredth of the history about it, and as both where that is below a tenth of a class.
std::vector<KvClass> kv_over_lift(History const& history, ValveFacts const& facts,
                                  int classes = 20);

/// Figures for summary.json, valve_cracking_pressure and the like; none that is not a number.
std::vector<core::Figure> figures(ValveRamp const& ramp);

/// The figures that there are, in lines for people.
std::string ramp_text(ValveRamp const& ramp);

/// The classes as a file with a header.
std::string csv(std::vector<KvClass> const& classes);

}  // namespace velum::cases
