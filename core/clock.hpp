#pragma once
#include <cstdint>

namespace velum::core {

/// Counts the steps of a run. The time is derived, never summed up, so that it does not drift.
struct Clock {
  double dt;              // physical length of a step, s
  std::int64_t step = 0;  // steps done
  double start = 0;       // physical time at step 0, s
};

/// Physical time, s.
inline double time(Clock const& clock)
{
  return clock.start + static_cast<double>(clock.step) * clock.dt;
}

/// True at step 0 and at every n-th after it; n <= 0 means never.
inline bool every(Clock const& clock, std::int64_t n) { return n > 0 && clock.step % n == 0; }

/// Steps between two events that are `interval` seconds apart, rounded to the nearest; at least 1.
std::int64_t steps_in(Clock const& clock, double interval);

}  // namespace velum::core
