#pragma once
#include <chrono>
#include <cstdio>
#include <string>

namespace velum::cases {

/// What the live line shows.
struct Progress {
  double time, end;           // s
  double mlups = 0;           // million cell updates per second so far; 0: there is no lattice
  double mach = 0;            // worst so far
  std::string coupling = "";  // state of the coupling in a few words
};

/// The text of the line: time, share done, time left; of a lattice speed and worst Mach number;
/// coupling.
/// @param elapsed  wall time since the run began at time 0, s
std::string progress_text(Progress const& progress, double elapsed);

/// Writes one live line: on a terminal rewritten in place, at most five times a second; elsewhere a
/// plain line at every tenth of the run; nothing when quiet.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet, std::FILE* stream = stdout);
  ProgressLine(bool quiet, std::FILE* stream, bool terminal);

  /// Cheap enough to be called every few steps.
  void show(Progress const& progress);
  /// Ends the line on a terminal, so that what follows begins below it.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  bool quiet_, terminal_;
  std::FILE* stream_;
  Clock::time_point start_ = Clock::now(), last_{};
  std::size_t width_ = 0;  // of the line on the terminal
  int tenths_ = -1;        // already written as plain lines
};

}  // namespace velum::cases
