#include "core/clock.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

using namespace core;

TEST(Clock, does_not_drift)
{
  Clock clock{0.1};
  for (int k = 0; k < 10'000'000; ++k) ++clock.step;
  EXPECT_EQ(time(clock), 1e6);
  EXPECT_EQ(time(Clock{0.1, 5, 2}), 2.5);
}

TEST(Clock, is_due_at_step_zero_and_every_nth)
{
  EXPECT_TRUE(every(Clock{1, 0}, 3));
  EXPECT_FALSE(every(Clock{1, 2}, 3));
  EXPECT_TRUE(every(Clock{1, 3}, 3));
  EXPECT_FALSE(every(Clock{1, 0}, 0));
}

TEST(Clock, an_interval_is_a_whole_number_of_steps)
{
  EXPECT_EQ(steps_in(Clock{1e-7}, 1e-3), 10000);
  EXPECT_EQ(steps_in(Clock{1e-3}, 1e-9), 1);
}

}  // namespace
}  // namespace velum::tests
