#pragma once
#include <string>
#include <vector>

#include "core/output/summary.hpp"

/// Whether a valve chatters: the oscillation of the gap between its membrane and its seat.
namespace velum::cases {

/// What is looked at, over time. SI units; the times increase, evenly or not.
struct ChatterSignals {
  std::vector<double> time;
  std::vector<double> gap;       // <= 0 in contact
  std::vector<double> pressure;  // difference across the seat: outside less inside
  std::vector<double> flow;
};

/// What counts as an oscillation.
struct ChatterRule {
  double threshold = 1e-6;  // m: amplitude about the slow mean from which on it counts
  double share = 0.8;       // of the swing's power, at least, within a fifth of one frequency about
                            // it and its first harmonics
  double fewest_cycles = 4;    // that it lasts
  double steady_change = 0.1;  // of the amplitude over the later half, at most, in a limit cycle
};

enum class ChatterKind { too_short, none, decaying, limit_cycle, growing };

/// The oscillation of a gap. What a kind lacks is not a number.
struct Chatter {
  ChatterKind kind;
  double cycles = 0;          // whole and half ones that were seen
  double onset, end;          // s: the amplitude is above the threshold between, to within a period
  double frequency;           // Hz
  double amplitude;           // peak to peak of the gap, mean of the last three cycles, m
  double largest;             // largest amplitude peak to peak, m
  double rate;                // d ln(amplitude) / dt over the later half, 1/s; < 0 decays
  double pressure_phase;      // by which the pressure difference runs ahead of the gap, degrees
  double flow_phase;          // the flow ahead of the gap
  double flow_pressure;       // the flow ahead of the pressure difference
  double contacts_per_cycle;  // times that the gap closes
};

/// Finds the longest oscillation of the gap.
///
/// Samples are put on even times a median step apart. For each of the strongest frequencies of the
/// gap's velocity, between two periods in the record and five samples a period, the slow mean of
/// the gap (slow_mean(): a Hann window of two periods) is taken off; the amplitude of what remains
/// is the same mean of it times exp(-i omega t). The first frequency that holds the rule is the
/// answer, corrected by the spectrum of the remainder between onset and end. Phases are those of
/// the signals' components at that frequency there, each less its own slow mean.
///
/// The kind is too_short where there are fewer than 32 samples, or an oscillation has begun but the
/// record ends before the fewest cycles.
Chatter find_chatter(ChatterSignals const& signals, ChatterRule const& rule = {});

/// Figures for summary.json, all named chatter_...: chatter_cycles alone where there is none, and
/// that not a number where the record is too short.
std::vector<core::Figure> figures(Chatter const& chatter);

/// What was found, in lines for people.
std::string chatter_text(Chatter const& chatter, ChatterRule const& rule = {});

}  // namespace velum::cases
