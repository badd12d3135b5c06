// problem:    tests of rubber of known coefficients, without and with errors of 1 % of the modulus
// reference:  the planted coefficients
// measure:    without errors, the coefficients; with errors, the share of 1000 fits whose 95 %
//             interval holds the planted value, for each coefficient, for the shear modulus and for
//             the stress in a test that was not made
// tolerance:  1e-9 relative without errors; share 0.95 +- 0.025 with
// why:        condition (up to 1e4) times round-off; 3.6 standard errors of a share of 1000
#include "structure/fit.hpp"
#include "structure/student_t.hpp"
#include "tests/structure/planted_tests.hpp"

#include <gtest/gtest.h>

#include <array>

namespace velum::structure {
namespace {

constexpr std::array<double, 5> c{0.3, 0.05, 0.004, -0.002, 0.0006};

MooneyRivlin rubber_of(FitModel model)
{
  auto const at = [&](int k) { return k < parameters(model) ? c[static_cast<std::size_t>(k)] : 0; };
  return {at(0), at(1), at(2), at(3), at(4)};
}

std::vector<MaterialTest> tests_of(FitModel model, double noise, std::mt19937& random)
{
  auto const rubber = rubber_of(model);
  std::vector tests{
      planted(rubber, TestMode::uniaxial, StressKind::engineering, 2.5, 20, noise, random)};
  if (model == FitModel::neo_hookean) return tests;
  tests.push_back(planted(rubber, TestMode::planar, StressKind::true_, 2.2, 20, noise, random));
  if (model == FitModel::mooney_rivlin_2) return tests;
  tests.push_back(planted(rubber, TestMode::equibiaxial, StressKind::true_, 2, 20, noise, random));
  return tests;
}

TEST(Fit, without_errors_is_exact)
{
  std::mt19937 random(1);
  for (auto const model : all_fit_models)
    for (auto const weight : {FitWeight::alike, FitWeight::relative}) {
      auto const f = fit(model, tests_of(model, 0, random), weight);
      for (int k = 0; k < parameters(model); ++k)
        EXPECT_NEAR(f.coefficients[k], c[static_cast<std::size_t>(k)],
                    1e-9 * c[static_cast<std::size_t>(0)]);
      EXPECT_LT(f.relative_rms, 1e-12);
      EXPECT_FALSE(is_systematic(f));
    }
}

TEST(Fit, holds_the_planted_values_in_its_intervals)
{
  constexpr int fits = 1000;
  std::mt19937 random(2);
  for (auto const model : all_fit_models) {
    auto const rubber = rubber_of(model);
    int const p = parameters(model);
    std::vector<int> held(static_cast<std::size_t>(p) + 2, 0);
    int systematic = 0;
    for (int n = 0; n < fits; ++n) {
      auto const f = fit(model, tests_of(model, 0.01 * shear_modulus(rubber), random));
      auto const count = [&](int at, double error, double half) {
        held[static_cast<std::size_t>(at)] += std::abs(error) <= half ? 1 : 0;
      };
      for (int k = 0; k < p; ++k)
        count(k, f.coefficients[k] - c[static_cast<std::size_t>(k)], half_interval(f, k));
      count(p, shear_modulus(f.material) - shear_modulus(rubber),
            half_interval_of_shear_modulus(f));
      count(p + 1,
            engineering_stress(f.material, TestMode::equibiaxial, 1.8) -
                engineering_stress(rubber, TestMode::equibiaxial, 1.8),
            half_interval(f, TestMode::equibiaxial, 1.8));
      systematic += is_systematic(f) ? 1 : 0;
    }
    for (int const each : held) EXPECT_NEAR(each / double(fits), 0.95, 0.025) << p;
    EXPECT_LT(systematic, 0.05 * fits) << p;
  }
}

TEST(Fit, tells_misfit_from_noise)
{
  std::mt19937 random(3);
  auto const rubber = rubber_of(FitModel::mooney_rivlin_2);
  std::vector const tests{
      planted(rubber, TestMode::uniaxial, StressKind::engineering, 2.5, 30, 0.002, random)};
  EXPECT_TRUE(is_systematic(fit(FitModel::neo_hookean, tests)));
  EXPECT_FALSE(is_systematic(fit(FitModel::mooney_rivlin_2, tests)));
}

TEST(Fit, refuses_what_cannot_be_told)
{
  std::mt19937 random(4);
  auto const rubber = rubber_of(FitModel::mooney_rivlin_2);
  auto const sentence = [](FitModel model, std::vector<MaterialTest> const& tests) {
    try {
      fit(model, tests);
    } catch (std::exception const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  auto const few = planted(rubber, TestMode::uniaxial, StressKind::engineering, 2, 2, 0.01, random);
  EXPECT_EQ(sentence(FitModel::mooney_rivlin_2, {few}),
            "2 points away from rest are too few for 2 parameters; it takes at least 3.");
  // in planar tension both invariants are one
  auto const planar =
      planted(rubber, TestMode::planar, StressKind::engineering, 2, 30, 0.01, random);
  EXPECT_EQ(sentence(FitModel::neo_hookean, {planar}), "");
  EXPECT_EQ(sentence(FitModel::mooney_rivlin_2, {planar}),
            "these tests cannot tell its 2 parameters apart; add a test of another kind or of "
            "larger stretches.");
}

TEST(Student, quantiles_are_those_of_the_tables)
{
  // Abramowitz and Stegun, table 26.10
  EXPECT_NEAR(student_quantile(1, 0.95), 12.706, 5e-4);
  EXPECT_NEAR(student_quantile(2, 0.95), 4.303, 5e-4);
  EXPECT_NEAR(student_quantile(5, 0.95), 2.571, 5e-4);
  EXPECT_NEAR(student_quantile(10, 0.95), 2.228, 5e-4);
  EXPECT_NEAR(student_quantile(30, 0.95), 2.042, 5e-4);
  EXPECT_NEAR(student_quantile(120, 0.95), 1.980, 5e-4);
  EXPECT_NEAR(student_quantile(7, 0.99), 3.499, 5e-4);
}

}  // namespace
}  // namespace velum::structure
