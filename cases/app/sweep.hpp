#pragma once
#include "core/output/summary.hpp"

#include <string>
#include <vector>

namespace velum::cases {

/// A key of a scene and the values that a sweep gives it, as typed.
struct SweepAxis {
  std::string key;
  std::vector<std::string> values;
};

/// The axes of "key=value,value,...". A comma within brackets, braces or quotes belongs to a value.
/// @throws core::InputError  no '=', no or an empty value, one value or key twice, a bracket or a
///                           quotation mark that is not closed
std::vector<SweepAxis> read_axes(std::vector<std::string> const& texts);

/// One run of a sweep.
struct SweepRun {
  std::vector<std::string> values;  // one per axis
  std::string folder;
  std::string outcome{};  // "ok", or the sentence with which it failed; empty: not run yet
  std::vector<core::Figure> figures{};
};

/// All combinations, the last key changing fastest. Folders are called after the values,
/// pressure_50kPa_lift_20um, by the last words of the keys where these differ; a value that is a
/// table, too long for a name, or would have that of another, gives its number: lift_no2.
std::vector<SweepRun> sweep_runs(std::vector<SweepAxis> const& axes);

/// The table, a row for each run so far: the keys with their values as typed, `outcome`, and every
/// figure that any run has as `name [unit]`, empty where a run has it not, nan where it is unknown
/// there.
std::string csv(std::vector<SweepAxis> const& axes, std::vector<SweepRun> const& runs);

/// Names of the figures to show: those asked for; otherwise of a valve its final flow, gap and
/// pressure above and its chatter, as far as any run has them; otherwise the first four that differ
/// between runs, but for what the computation cost.
std::vector<std::string> shown_figures(std::vector<SweepRun> const& runs,
                                       std::vector<std::string> const& asked);

/// @throws core::InputError  a name that no run has, with the nearest that one has; nothing where
///                           no run came to its end
void check_shown(std::vector<SweepRun> const& runs, std::vector<std::string> const& asked);

/// A run in a line: its values, each as wide as the widest of its axis, and the figures shown in
/// units that are read easily; or how it failed.
std::string run_text(std::vector<SweepAxis> const& axes, SweepRun const& run,
                     std::vector<std::string> const& shown);

}  // namespace velum::cases
