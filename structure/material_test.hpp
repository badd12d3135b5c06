#pragma once
#include "structure/mooney_rivlin.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace velum::structure {

/// Homogeneous tests of incompressible rubber, named by the stretch l that is imposed:
///   uniaxial     l, l^-1/2, l^-1/2   a strip is pulled (or a button pressed)
///   equibiaxial  l, l, l^-2          a sheet is pulled along both sides; the pole of a bulge
///   planar       l, 1, l^-1          a wide strip is pulled: pure shear
enum class TestMode { uniaxial, equibiaxial, planar };
inline constexpr std::array all_test_modes{TestMode::uniaxial, TestMode::planar,
                                           TestMode::equibiaxial};

/// Engineering (nominal) stress is force per undeformed area, true (Cauchy) stress force per
/// deformed area. In all three tests true = l * engineering.
enum class StressKind { engineering, true_ };

/// Points of one test. Any consistent unit of stress.
struct MaterialTest {
  TestMode mode;
  StressKind kind;
  std::vector<double> stretch, stress;
};

/// The two stretches in the plane of the sheet.
struct PlaneStretch {
  double l1, l2;
};

inline PlaneStretch plane_stretch(TestMode mode, double l)
{
  switch (mode) {
    case TestMode::uniaxial:
      return {l, 1 / std::sqrt(l)};
    case TestMode::equibiaxial:
      return {l, l};
    case TestMode::planar:
      break;
  }
  return {l, 1};
}

/// Invariants along a test, less 3, and what the loads do on them: the engineering stress is
/// N = n1 dW/dI1 + n2 dW/dI2, with n = dI/dl (half of it where two loads share the work).
/// Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5; Treloar, The Physics of Rubber
/// Elasticity (1975), chapter 5.
struct TestInvariants {
  double i1, i2, n1, n2;
};

inline TestInvariants test_invariants(TestMode mode, double l)
{
  double const r = 1 / l, r2 = r * r, r3 = r2 * r;
  switch (mode) {
    case TestMode::uniaxial:
      return {l * l + 2 * r - 3, 2 * l + r2 - 3, 2 * (l - r2), 2 * (1 - r3)};
    case TestMode::equibiaxial:
      return {2 * l * l + r2 * r2 - 3, l * l * l * l + 2 * r2 - 3, 2 * (l - r2 * r3),
              2 * (l * l * l - r3)};
    case TestMode::planar:
      break;
  }
  double const i = l * l + r2 - 2, n = 2 * (l - r3);
  return {i, i, n, n};
}

/// Engineering stress per coefficient, in the order c10, c01, c20, c11, c02: the stress is linear
/// in them.
inline std::array<double, 5> stress_terms(TestMode mode, double l)
{
  auto const [i1, i2, n1, n2] = test_invariants(mode, l);
  return {n1, n2, 2 * i1 * n1, i2 * n1 + i1 * n2, 2 * i2 * n2};
}

inline double engineering_stress(MooneyRivlin const& m, TestMode mode, double l)
{
  auto const t = test_invariants(mode, l);
  auto const w = invariant_energy(m, t.i1, t.i2);
  return t.n1 * w.W1 + t.n2 * w.W2;
}

/// What engineering stress has to be multiplied with to be of the other kind.
inline double per_engineering(StressKind kind, double l)
{
  return kind == StressKind::true_ ? l : 1;
}

}  // namespace velum::structure
