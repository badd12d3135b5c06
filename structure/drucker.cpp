#include "structure/drucker.hpp"

#include "structure/membrane_energy.hpp"

#include <cmath>

namespace velum::structure {
namespace {

constexpr int steps = 400;

/// Last stable stretch on the way from rest to an end: steps, then bisection.
double last_stable(MooneyRivlin const& m, TestMode mode, double end)
{
  auto const stable = [&](double l) {
    auto const [l1, l2] = plane_stretch(mode, l);
    return is_stable(m, l1, l2);
  };
  double good = 1;
  if (!stable(good)) return good;
  for (int k = 1; k <= steps; ++k) {
    double bad = std::pow(end, double(k) / steps);
    if (stable(bad)) {
      good = bad;
      continue;
    }
    for (int n = 0; n < 40; ++n) {
      double const middle = (good + bad) / 2;
      (stable(middle) ? good : bad) = middle;
    }
    return good;
  }
  return end;
}

}  // namespace

bool is_stable(MooneyRivlin const& m, double l1, double l2)
{
  auto const w = membrane_energy(m, 1, l1, l2);
  double const d11 = l1 * (l1 * w.K11 + w.T1), d22 = l2 * (l2 * w.K22 + w.T2);
  double const d12 = l1 * l2 * w.K12;
  return d11 > 0 && d11 * d22 > d12 * d12;
}

StretchRange stable_range(MooneyRivlin const& m, TestMode mode, StretchRange const& searched)
{
  return {last_stable(m, mode, searched.from), last_stable(m, mode, searched.to)};
}

}  // namespace velum::structure
