#include <gtest/gtest.h>

#include <cmath>

#include "cases/app/oscillation.hpp"

namespace velum {
namespace {

/// A sine that has grown to its full height after a third of the run.
std::vector<double> signal(std::vector<double> const& time, double period, double phase)
{
  std::vector<double> values;
  for (double t : time)
    values.push_back(0.2 + std::min(1.0, 3 * t / time.back()) *
                               std::sin(2 * std::acos(-1.0) * (t / period + phase)));
  return values;
}

TEST(Oscillation, PeriodTopAndMeanAreThoseOfTheSine)
{
  std::vector<double> time;
  for (int k = 0; k <= 1000; ++k) time.push_back(0.01 * k);
  for (double phase : {0.0, 0.13, 0.5, 0.77}) {
    auto const value = signal(time, 0.731, phase);
    auto const found = cases::last_periods(time, value, 1e-3);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->period, 0.731, 1e-4);
    EXPECT_NEAR(cases::largest(time, value, found->begin, found->end), 1.2, 1e-5);
    EXPECT_NEAR(cases::mean(time, value, found->begin, found->end), 0.2, 0.01);
    EXPECT_NEAR(cases::at_time(time, value, found->top + found->period / 2), -0.8, 2e-3);
  }
}

TEST(Oscillation, WhatIsSteadyOrTooShortHasNone)
{
  std::vector<double> time, flat, slow;
  for (int k = 0; k <= 100; ++k) {
    time.push_back(k);
    flat.push_back(1 + 1e-6 * (k % 2));
    slow.push_back(std::sin(0.03 * k));
  }
  EXPECT_FALSE(cases::last_periods(time, flat, 1e-3));
  EXPECT_FALSE(cases::last_periods(time, slow, 1e-3));
}

}  // namespace
}  // namespace velum
