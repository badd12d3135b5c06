// problem:    clamped neo-Hookean disc under a pressure below and above its inflation limit
// reference:  limit point p a/(mu H) = 1.879 at w0/a = 1.17 (shooting; energy minimisation)
// measure:    below: deflection on the first branch; above: the error and what it says
// tolerance:  1.86 must be carried, 1.90 must not; the carried share within 1 % of 1.879 / 1.90
// why:        80 elements put the limit within 0.1 %; the search stops at load steps of 0.1 %
#include "core/check.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/static_solve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace velum::structure {
namespace {

Membrane disc()
{
  return flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / 80, [](double) { return 0.01; },
                        neo_hookean_rubber(100), 1});
}

TEST(InflationLimit, is_carried_below)
{
  auto m = disc();
  auto const pressure = uniform_pressure(m, Side::minus, 1.86);
  std::array const loads{pressure_load(m, pressure)};
  auto const report = static_solve(m, loads);
  EXPECT_LT(report.residual, 1e-9);
  EXPECT_GT(m.position[0], 0.95);
  EXPECT_LT(m.position[0], 1.17);
}

TEST(InflationLimit, is_reported_above)
{
  auto m = disc();
  auto const pressure = uniform_pressure(m, Side::minus, 1.90);
  std::array const loads{pressure_load(m, pressure)};
  try {
    static_solve(m, loads);
    FAIL() << "a load above the limit point was accepted, w0/a = " << m.position[0];
  } catch (core::Divergence const& error) {
    std::string const what = error.what();
    EXPECT_NE(what.find("limit point of inflation"), std::string::npos) << what;
    EXPECT_NE(what.find("at node"), std::string::npos) << what;
    double carried = 0;
    ASSERT_EQ(std::sscanf(what.c_str(), "no stable static equilibrium beyond %lf", &carried), 1);
    EXPECT_NEAR(carried, 1.879 / 1.90, 0.01);
  }
}

}  // namespace
}  // namespace velum::structure
