#pragma once
#include <stdexcept>

namespace velum::cases {

/// The run ended early on a signal or at a limit, with its state and output complete. Exit code 4.
struct Stopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// From now on the first SIGINT or SIGTERM only makes stop_requested() true; a second one ends the
/// process at once.
void catch_stop_signals();

/// Asks as a signal would, or takes it back.
void request_stop(bool stop = true);

/// True once a signal has asked the run to stop; to be asked between steps.
bool stop_requested();

}  // namespace velum::cases
