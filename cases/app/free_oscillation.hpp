#pragma once
#include "cases/app/history.hpp"
#include "core/output/summary.hpp"

#include <vector>

namespace velum::cases {

/// How the middle of a membrane that touches nothing swings at the end of a run, from its upward
/// crossings of its mean: free_frequency, and free_damping_ratio, the decrement of the turns
/// between them over 2 pi. Nothing where the last half of the run has fewer than two crossings.
std::vector<core::Figure> free_oscillation(History const& history);

}  // namespace velum::cases
