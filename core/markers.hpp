#pragma once
#include "core/vec.hpp"

#include <vector>

namespace velum::core {

/// Points of a body's mid-surface, as contact sees them: any consistent set of units, host arrays
/// of one length.
struct Markers {
  std::vector<Vec2> X;         // position
  std::vector<Vec2> V;         // velocity
  std::vector<Vec2> F;         // force on the marker: of its whole ring, or per unit depth
  std::vector<double> area;    // share of the mid-surface: of its whole ring, or per unit depth
  std::vector<double> offset;  // half thickness: distance of the wet faces from X
};

}  // namespace velum::core
