// problem:   the middle of a membrane, a decaying line at 38.5 and 124 Hz beside two faster ones
// and
//            a slow drift, over 6 to 20 periods, sampled unevenly
// reference: the line's own frequency and damping ratio, 0.002 to 0.05
// measure:   free_frequency, free_damping_ratio
// tolerance: 0.5 %; 0.001
// why:       two windows of two periods and more tell the phase to some hundredths of a turn
#include <gtest/gtest.h>

#include <cmath>

#include "cases/app/free_oscillation.hpp"

namespace velum {
namespace {

cases::History rung(double f, double damping, double periods)
{
  double const pi = std::acos(-1.0), end = periods / f;
  cases::History h;
  h.columns = {{"centre", "m"}};
  for (double t = 0; t < end; t += end / 900 * (1 + 0.3 * std::sin(1e5 * t))) {
    double const line = std::exp(-2 * pi * damping * f * t) * std::cos(2 * pi * f * t + 0.7);
    double const others = 0.4 * std::exp(-30 * t) * std::sin(2 * pi * 4.7 * f * t) +
                          0.2 * std::cos(2 * pi * 9.1 * f * t) + 0.1 * t / end;
    h.time.push_back(t);
    h.rows.push_back({1e-4 * (line + others)});
  }
  return h;
}

TEST(FreeOscillation, IsThatOfTheStrongestLine)
{
  for (double f : {38.5, 124.0})
    for (double damping : {0.002, 0.01, 0.05})
      for (double periods : {6.5, 12.0, 20.0}) {
        auto const figures = cases::free_oscillation(rung(f, damping, periods));
        ASSERT_EQ(figures.size(), 2u);
        if (damping * periods > 0.4) continue;  // the other lines are stronger in the end
        EXPECT_NEAR(figures[0].value / f, 1, 0.005) << f << " " << damping << " " << periods;
        EXPECT_NEAR(figures[1].value, damping, 1e-3) << f << " " << damping << " " << periods;
      }
}

TEST(FreeOscillation, IsNothingWhereThereAreTooFewPeriods)
{
  EXPECT_TRUE(cases::free_oscillation(rung(100, 0.01, 2)).empty());
}

}  // namespace
}  // namespace velum
