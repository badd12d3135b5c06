#pragma once
#include "structure/material_test.hpp"

#include <random>

namespace velum::structure {

/// Points of a test of a known rubber between rest and a largest stretch, with errors of normal
/// distribution in the stress as measured.
inline MaterialTest planted(MooneyRivlin const& rubber, TestMode mode, StressKind kind,
                            double largest, int points, double noise, std::mt19937& random)
{
  std::normal_distribution<double> error(0, 1);
  MaterialTest test{mode, kind, {}, {}};
  for (int k = 1; k <= points; ++k) {
    double const l = 1 + (largest - 1) * k / points;
    test.stretch.push_back(l);
    test.stress.push_back(per_engineering(kind, l) * engineering_stress(rubber, mode, l) +
                          noise * error(random));
  }
  return test;
}

}  // namespace velum::structure
