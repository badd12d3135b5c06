// problem:   a history made from formulas: the pressure difference falls from 300 to 20 kPa and
//            rises again; the gap follows one line on the way down and another on the way up
// reference: the lines: shut at 48 kPa, open from 58; the Kv of the flow put in
// measure:   cracking and reseating pressure, hysteresis; Kv in each class of gaps
// tolerance: 0.1 kPa; 1 % of Kv
// why:       crossings are read on straight lines between samples 1 kPa apart, on which gap and
//            pressure are straight themselves; Kv is a mean over a class, in which it changes by
//            less than that about its middle
#include "cases/app/valve_ramp.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::tests {
namespace {

constexpr double seals = 1e-6, per_gap = 1200;  // Kv per metre of gap, m3/h

/// Gap on the way down or up: a straight line that is at the sealing width at one pressure.
double gap_at(double p, bool rising)
{
  double const width = seals + (p - (rising ? 58e3 : 48e3)) * 4e-10;
  return std::max(width, -0.2e-6);
}

double pressure_at(double t)
{
  return t < 0.28 ? 300e3 - t * 1e6 : t < 0.3 ? 20e3 : 20e3 + (t - 0.3) * 1e6;
}

cases::History history()
{
  cases::History h{{{"pressure_above", "Pa"},
                    {"pressure_outside", "Pa"},
                    {"pressure_inside", "Pa"},
                    {"gap", "m"},
                    {"flow", "m3/s"}},
                   {},
                   {}};
  for (int k = 0; k <= 580; ++k) {
    double const t = 1e-3 * k, p = pressure_at(t), gap = gap_at(p, t > 0.29);
    double const kv = gap > seals ? per_gap * gap : 0;
    h.time.push_back(t);
    h.rows.push_back({p / 2, p, 0, gap, kv / 3600 * std::sqrt(p / 1e5)});
  }
  return h;
}

cases::ValveFacts facts()
{
  return {.density = 1000,
          .seals_at = seals,
          .inlet = {{0, 0.28, 0.3, 0.58}, {300e3, 20e3, 20e3, 300e3}},
          .outlet = cases::constant(0)};
}

TEST(ValveRamp, tells_where_the_valve_cracks_and_reseats)
{
  auto const ramp = cases::valve_ramp(history(), facts());
  EXPECT_NEAR(ramp.cracks, 58e3, 100);
  EXPECT_NEAR(ramp.reseats, 48e3, 100);
  EXPECT_NEAR(ramp.hysteresis, 10e3, 200);
  EXPECT_EQ(cases::figures(ramp).size(), 3);
}

TEST(ValveRamp, is_none_where_the_difference_is_steady)
{
  auto steady = facts();
  steady.inlet = cases::constant(300e3);
  EXPECT_TRUE(cases::figures(cases::valve_ramp(history(), steady)).empty());
  EXPECT_EQ(cases::ramp_text(cases::valve_ramp(history(), steady)), "");
}

TEST(KvOverLift, is_that_of_the_flow_both_ways)
{
  auto const classes = cases::kv_over_lift(history(), facts());
  ASSERT_EQ(classes.size(), 20);
  for (auto const& c : classes) {
    if (c.gap < 10e-6) continue;  // a few samples, not even about the middle
    EXPECT_NEAR(c.closing, per_gap * c.gap, 0.01 * per_gap * c.gap) << c.gap;
    if (c.gap < 90e-6) {  // the way up ends at a smaller gap
      EXPECT_NEAR(c.opening, per_gap * c.gap, 0.01 * per_gap * c.gap) << c.gap;
    }
  }
}

TEST(KvOverLift, of_a_valve_that_stays_shut_is_empty)
{
  auto shut = history();
  for (auto& row : shut.rows) row[3] = -1e-7;
  EXPECT_TRUE(cases::kv_over_lift(shut, facts()).empty());
}

}  // namespace
}  // namespace velum::tests
