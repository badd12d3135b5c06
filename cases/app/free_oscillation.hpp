#pragma once
#include "cases/app/history.hpp"
#include "core/output/summary.hpp"

#include <vector>

namespace velum::cases {

/// How the middle of a membrane that touches nothing swings in the last two thirds of a run, at the
/// strongest line of its spectrum: free_frequency, by the turn of its phase from the first half of
/// that time to the second, and free_damping_ratio, by the fall of its amplitude between them,
/// ln(A1/A2) / (2 pi f dt). Nothing where either half holds fewer than two periods.
std::vector<core::Figure> free_oscillation(History const& history);

}  // namespace velum::cases
