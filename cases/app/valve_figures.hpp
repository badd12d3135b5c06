#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cases/app/curve.hpp"
#include "cases/app/history.hpp"
#include "core/output/summary.hpp"

/// What a valve designer reads off a run.
namespace velum::cases {

/// A figure that a history does not have.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What the history of a valve does not tell. SI units.
struct ValveFacts {
  double density;                       // of the liquid
  double seals_at;                      // gap up to which the valve is shut
  Curve inlet, outlet;                  // pressures over time, above the atmosphere
  double seat_diameter = 0;             // 0: unknown
  std::optional<double> pilot_opens{};  // s; empty: when the first lift of the history rises
  double vapour_pressure = 2339;        // of water at 20 degrees C, absolute
  double atmosphere = 101325;
};

/// Difference of the pressures of inlet and outlet at a time.
double difference(ValveFacts const& facts, double time);

/// Kv, m3/h of water at 1 bar: Q sqrt(density / 1000 / dp[bar]), of a flow in m3/s; not a number
/// where nothing drives it.
double kv(double flow, double difference, double density);

/// Figures of a valve, SI; not a number where the history has no answer. "Final" is the mean over
/// the last tenth of the time.
struct ValveSheet {
  double pilot_opens;     // s: a lift begins to rise (by a hundredth of its whole rise)
  double opens;           // s: the gap first exceeds seals_at
  double chamber_final;   // pressure above the membrane, Pa
  double chamber_time;    // s from pilot_opens until it stays within 5 % of that
  double flow_final;      // out of the valve, with the pilot's share, m3/s
  double flow_end;        // of the last row, where the last tenth is still under way
  double flow_largest;    // m3/s
  double flow_rise;       // s from 10 to 90 % of the way to the final flow, at first passage
  double gap_final;       // m
  double gap_end;         // m
  double gap_largest;     // m
  double kv;              // of the final state, m3/h at 1 bar
  double leak;            // mean flow over the later half of the time shut before the pilot opens
  double leak_class;      // 1 to 5, see leak_class()
  double pressure_least;  // of the mean pressure within the seat, Pa; a cell may have less
  double cell_least;      // pressure in any cell of the lattice at the samples, Pa; not a number
                          // without a lattice
  double cavitation;      // (outlet - vapour) / (inlet - outlet) of the final state, absolute
};

/// Class of a leak by FCI 70-2 (IEC 60534-4): V where it is at most 5e-4 ml/min for each inch of
/// the seat's diameter and psi of the difference; else IV, III, II at 0.01, 0.1, 0.5 % of the open
/// valve's flow at that difference; else I. Of the standard only the limits: the difference is the
/// run's, the liquid its own. Not a number where what it takes is unknown.
/// @param open_flow      m3/s at that difference; 0: unknown
/// @param seat_diameter  m; 0: unknown
double leak_class(double leak, double difference, double open_flow, double seat_diameter);

/// @pre the history has the columns gap, flow, pressure_above and pressure_inside, and two rows
ValveSheet valve_sheet(History const& history, ValveFacts const& facts);

/// Figures for summary.json, all named valve_...
std::vector<core::Figure> figures(ValveSheet const& sheet);
inline std::vector<core::Figure> valve_figures(History const& history, ValveFacts const& facts)
{
  return figures(valve_sheet(history, facts));
}

/// The figures that there are, in lines for people.
std::string valve_text(ValveSheet const& sheet);

}  // namespace velum::cases
