// problem:    tensions and stiffness of a membrane of five-parameter Mooney-Rivlin rubber
// reference:  central differences of the energy and of the tensions with step 1e-6; for one
//             parameter mu H / 2 (l1^2 + l2^2 + (l1 l2)^-2 - 3), Holzapfel (2000), written out
// measure:    difference relative to the sum of the coefficients; for one parameter to the value
// tolerance:  1e-8; for one parameter 4e-15
// why:        the differences err by step^2 times the fourth derivative, some 1e3, and by round-off
//             over step, 1e-10 times the largest entries, some 10; a few roundings for one
//             parameter
#include "structure/membrane_energy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace velum::structure {
namespace {

constexpr double H = 0.7;
constexpr std::array<std::array<double, 2>, 5> states{
    {{1, 1}, {1.3, 1.1}, {1.7, 1}, {1.2, 0.9}, {1.6, 1.6}}};

TEST(MembraneEnergy, derivatives_are_those_of_the_energy)
{
  MooneyRivlin const m{.c10 = 0.3, .c01 = 0.05, .c20 = 0.02, .c11 = -0.01, .c02 = 0.004};
  double const step = 1e-6, tolerance = 1e-8;
  for (auto const [l1, l2] : states) {
    auto const w = membrane_energy(m, H, l1, l2);
    auto const right = membrane_energy(m, H, l1 + step, l2);
    auto const left = membrane_energy(m, H, l1 - step, l2);
    auto const over = membrane_energy(m, H, l1, l2 + step);
    auto const under = membrane_energy(m, H, l1, l2 - step);
    EXPECT_NEAR(w.T1, (right.W - left.W) / (2 * step), tolerance);
    EXPECT_NEAR(w.T2, (over.W - under.W) / (2 * step), tolerance);
    EXPECT_NEAR(w.K11, (right.T1 - left.T1) / (2 * step), tolerance);
    EXPECT_NEAR(w.K12, (right.T2 - left.T2) / (2 * step), tolerance);
    EXPECT_NEAR(w.K12, (over.T1 - under.T1) / (2 * step), tolerance);
    EXPECT_NEAR(w.K22, (over.T2 - under.T2) / (2 * step), tolerance);
  }
}

TEST(MembraneEnergy, of_one_parameter_is_neo_hookean)
{
  double const mu = 0.946;
  auto const near = [](double value, double expected) {
    EXPECT_NEAR(value, expected, 4e-15 * std::max(1.0, std::abs(expected)));
  };
  for (auto const [l1, l2] : states) {
    auto const w = membrane_energy(neo_hookean_rubber(mu), H, l1, l2);
    double const a = 1 / (l1 * l1), b = 1 / (l2 * l2);
    near(w.W, 0.5 * mu * H * (l1 * l1 + l2 * l2 + a * b - 3));
    near(w.T1, mu * H * (l1 - a * b / l1));
    near(w.T2, mu * H * (l2 - a * b / l2));
    near(w.K11, mu * H * (1 + 3 * a * a * b));
    near(w.K12, mu * H * 2 * a * b / (l1 * l2));
    near(w.K22, mu * H * (1 + 3 * a * b * b));
  }
}

}  // namespace
}  // namespace velum::structure
