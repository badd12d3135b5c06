#include "structure/student_t.hpp"

#include <cmath>
#include <numbers>

namespace velum::structure {
namespace {

/// Share within tan(angle) sqrt(degrees) standard errors.
double share_within(double angle, int degrees)
{
  double const c2 = std::cos(angle) * std::cos(angle);
  bool const odd = degrees % 2 == 1;
  double term = odd ? std::cos(angle) : 1, sum = degrees == 1 ? 0 : term;
  for (int k = odd ? 3 : 2; k < degrees; k += 2) {
    term *= c2 * (k - 1) / k;
    sum += term;
  }
  sum *= std::sin(angle);
  return odd ? 2 / std::numbers::pi * (angle + sum) : sum;
}

}  // namespace

double student_quantile(int degrees, double share)
{
  double low = 0, high = std::numbers::pi / 2;
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (share_within(middle, degrees) < share ? low : high) = middle;
  }
  return std::tan(low) * std::sqrt(degrees);
}

}  // namespace velum::structure
