#include "cases/app/curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace velum::cases {

Curve constant(double value) { return {{0.0}, {value}}; }

double value_at(Curve const& curve, double t)
{
  auto const next = std::upper_bound(curve.at.begin(), curve.at.end(), t);
  if (next == curve.at.begin()) return curve.value.front();
  if (next == curve.at.end()) return curve.value.back();
  auto const k = static_cast<std::size_t>(next - curve.at.begin());
  double const share = (t - curve.at[k - 1]) / (curve.at[k] - curve.at[k - 1]);
  return std::lerp(curve.value[k - 1], curve.value[k], share);
}

double largest_magnitude(Curve const& curve)
{
  double largest = 0;
  for (double const value : curve.value) largest = std::max(largest, std::abs(value));
  return largest;
}

bool is_constant(Curve const& curve)
{
  return std::all_of(curve.value.begin(), curve.value.end(),
                     [&](double value) { return value == curve.value.front(); });
}

}  // namespace velum::cases
