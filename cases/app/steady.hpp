#pragma once
#include "cases/app/sample.hpp"

#include <vector>

namespace velum::cases {

/// Says when a flow has come to rest in time: compares the velocity field with itself one
/// characteristic time before,
///   change = |u(t) - u(t - T)| / |u(t)|,  L2 norms over the cells.
/// T is the length of the reference (without one the longer side of the box) over
/// the reference velocity, rounded to whole steps.
class SteadyTest {
 public:
  /// @param limit   of the change; 0: never steady
  /// @param period  T in steps
  SteadyTest(double limit, long period) : limit_(limit), period_(period) {}

  bool due(long step) const { return limit_ > 0 && step % period_ == 0; }
  /// True when the change has fallen below the limit.
  bool passed(lbm::CellStates const& cells);
  /// The last change; 1 before there were two fields to compare.
  double change() const { return change_; }
  long period() const { return period_; }

 private:
  double limit_, change_ = 1;
  long period_;
  std::vector<double> before_;
};

}  // namespace velum::cases
