#pragma once
#include <utility>
#include <vector>

#include "core/geometry/bounds.hpp"

namespace velum::contact {

using Pair = std::pair<int, int>;

/// All pairs (i, j) where box i of the first list meets box j of the second, in ascending order:
/// cells of a uniform grid, sorted, so that the time grows as the number of boxes and pairs (times
/// a logarithm).
std::vector<Pair> near_pairs(std::vector<core::Bounds> const& first,
                             std::vector<core::Bounds> const& second);

}  // namespace velum::contact
