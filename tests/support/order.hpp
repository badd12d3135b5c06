#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

namespace velum::tests {

/// Order of convergence: slope of the least-squares line through (log h, log e).
inline double order(std::vector<double> const& h, std::vector<double> const& e)
{
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  auto const n = static_cast<double>(h.size());
  for (std::size_t i = 0; i < h.size(); ++i) {
    double const x = std::log(h[i]), y = std::log(e[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace velum::tests
