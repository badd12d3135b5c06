#pragma once
#include <optional>
#include <vector>

namespace velum::cases {

/// The last whole periods of a signal.
struct Oscillation {
  double begin, end;  // first and last upward crossing of its mean, s
  double period;      // s
  double top;         // time of the largest value at least half a period before the end
};

/// Finds up to three whole periods at the end of a signal; nothing where its second half crosses
/// its mean upwards fewer than twice, or swings less than `noise` about it.
std::optional<Oscillation> last_periods(std::vector<double> const& time,
                                        std::vector<double> const& value, double noise);

/// Mean over [begin, end] by the trapezoidal rule.
double mean(std::vector<double> const& time, std::vector<double> const& value, double begin,
            double end);

/// Largest value in [begin, end], on the parabola through the samples beside the largest.
double largest(std::vector<double> const& time, std::vector<double> const& value, double begin,
               double end);

/// Value at t, straight between the samples.
double at_time(std::vector<double> const& time, std::vector<double> const& value, double t);

}  // namespace velum::cases
