#pragma once
#include "core/vec.hpp"

#include <algorithm>
#include <limits>

namespace velum::core {

/// Axis-parallel box around points; default-constructed it is empty.
struct Bounds {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 lo{infinity, infinity, infinity};
  Vec3 hi{-infinity, -infinity, -infinity};
};

inline void extend(Bounds& bounds, Vec3 const& p)
{
  for (int k = 0; k < 3; ++k) {
    bounds.lo[k] = std::min(bounds.lo[k], p[k]);
    bounds.hi[k] = std::max(bounds.hi[k], p[k]);
  }
}

inline void extend(Bounds& bounds, Bounds const& other)
{
  extend(bounds, other.lo);
  extend(bounds, other.hi);
}

inline double diagonal(Bounds const& bounds) { return norm(bounds.hi - bounds.lo); }

/// Square of the distance from p to the box, zero inside.
inline double distance2(Bounds const& bounds, Vec3 const& p)
{
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    double const d = std::max(std::max(bounds.lo[k] - p[k], p[k] - bounds.hi[k]), 0.0);
    sum += d * d;
  }
  return sum;
}

}  // namespace velum::core
