#pragma once
#include <vector>

namespace velum::cases {

/// A quantity tabulated over time or radius: straight between its points, constant beyond them.
/// A single point is a constant. SI units; `at` increases strictly.
struct Curve {
  std::vector<double> at, value;
};

/// The constant curve.
Curve constant(double value);
/// The curve's value at t.
double value_at(Curve const& curve, double t);
/// Largest magnitude on the curve; 0 when it is empty.
double largest_magnitude(Curve const& curve);
/// True when the curve has one value everywhere.
bool is_constant(Curve const& curve);

}  // namespace velum::cases
