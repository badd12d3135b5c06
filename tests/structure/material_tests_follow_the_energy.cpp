// problem:    uniaxial, planar and equibiaxial tests of five-parameter Mooney-Rivlin rubber
// reference:  work: the load does dW/dl, two loads of the equibiaxial test share it; central
//             differences of the membrane's energy along the test; the textbook's neo-Hookean laws
// measure:    engineering stress, as a whole and as the sum of its terms
// tolerance:  1e-8 for the differences, 1e-14 otherwise
// why:        step 1e-6: error of the scheme 1e-12 times some 1e3, round-off 1e-10 times some 10
#include "structure/material_test.hpp"
#include "structure/membrane_energy.hpp"

#include <gtest/gtest.h>

namespace velum::structure {
namespace {

constexpr MooneyRivlin rubber{.c10 = 0.3, .c01 = 0.05, .c20 = 0.02, .c11 = -0.01, .c02 = 0.004};

double energy(TestMode mode, double l)
{
  auto const [l1, l2] = plane_stretch(mode, l);
  return membrane_energy(rubber, 1, l1, l2).W;
}

TEST(MaterialTest, stress_is_the_work_of_the_load)
{
  double const step = 1e-6;
  for (auto const mode : all_test_modes)
    for (double const l : {0.8, 1.0, 1.2, 1.7}) {
      double const loads = mode == TestMode::equibiaxial ? 2 : 1;
      double const work = (energy(mode, l + step) - energy(mode, l - step)) / (2 * step);
      double const N = engineering_stress(rubber, mode, l);
      EXPECT_NEAR(N, work / loads, 1e-8);
      auto const t = stress_terms(mode, l);
      EXPECT_NEAR(N,
                  rubber.c10 * t[0] + rubber.c01 * t[1] + rubber.c20 * t[2] + rubber.c11 * t[3] +
                      rubber.c02 * t[4],
                  1e-14);
    }
}

TEST(MaterialTest, neo_hookean_laws_are_the_textbooks)
{
  double const mu = 0.946, l = 1.8;
  auto const m = neo_hookean_rubber(mu);
  EXPECT_NEAR(engineering_stress(m, TestMode::uniaxial, l), mu * (l - 1 / (l * l)), 1e-14);
  EXPECT_NEAR(engineering_stress(m, TestMode::planar, l), mu * (l - 1 / (l * l * l)), 1e-14);
  EXPECT_NEAR(engineering_stress(m, TestMode::equibiaxial, l), mu * (l - std::pow(l, -5)), 1e-14);
  EXPECT_NEAR(per_engineering(StressKind::true_, l) * engineering_stress(m, TestMode::uniaxial, l),
              mu * (l * l - 1 / l), 1e-14);
}

}  // namespace
}  // namespace velum::structure
