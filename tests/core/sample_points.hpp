#pragma once
#include "core/vec.hpp"

#include <random>
#include <vector>

namespace velum::tests {

/// Points spread evenly at random over the rectangle lo, hi; the same ones at every call.
inline std::vector<core::Vec2> sample_points(core::Vec2 lo, core::Vec2 hi, int count)
{
  std::mt19937_64 generator(20240501);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<core::Vec2> points;
  for (int k = 0; k < count; ++k) {
    double const s = share(generator), t = share(generator);
    points.push_back({lo[0] + s * (hi[0] - lo[0]), lo[1] + t * (hi[1] - lo[1])});
  }
  return points;
}

}  // namespace velum::tests
