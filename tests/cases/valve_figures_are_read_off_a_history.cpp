// Problem: a history made from formulas: a pilot that lifts at 10 ms, a chamber that empties
//   exponentially, a gap and a flow that follow from 12 ms on.
// Reference: the formulas; Kv from the paper's 200 l/h at 3 bar, 0.1155 m3/h; the limits of
//   FCI 70-2.
// Measure: each figure.
// Tolerance: half a sample for times, 0.1 % for the rest.
// Why: times are read on straight lines between samples 0.1 ms apart; final values are means over
//   a tail in which the formulas still move by e^-10.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/app/valve_figures.hpp"

namespace velum {
namespace {

using cases::ValveFacts;

constexpr double step = 1e-4, open_flow = 200e-3 / 3600, tau = 9e-3;

cases::History history(double end = 0.15, double leak = 0)
{
  cases::History h{{{"pressure_above", "Pa"},
                    {"pressure_outside", "Pa"},
                    {"pressure_inside", "Pa"},
                    {"gap", "m"},
                    {"flow", "m3/s"},
                    {"lift_bleed", "m"},
                    {"lift_pilot", "m"}},
                   {},
                   {}};
  for (int k = 0; k * step <= end + step / 2; ++k) {
    double const t = k * step;
    double const lift = std::clamp((t - 0.01) / 0.005, 0.0, 1.0);
    double const fallen = t < 0.01 ? 0 : 1 - std::exp(-(t - 0.01) / tau);
    double const opened = t < 0.012 ? 0 : 1 - std::exp(-(t - 0.012) / tau);
    h.time.push_back(t);
    h.rows.push_back({300e3 - 140e3 * fallen, 300e3, -20e3 * opened, -2e-6 + 102e-6 * opened,
                      opened > 0 ? open_flow * opened
                      : lift > 0 ? 8e-6
                                 : leak,
                      1e-4, 4e-4 * lift});
  }
  return h;
}

ValveFacts facts()
{
  return {.density = 1000,
          .seals_at = 1e-6,
          .inlet = cases::constant(300e3),
          .outlet = cases::constant(0),
          .seat_diameter = 10.5e-3};
}

TEST(ValveFigures, AreThoseOfTheFormulas)
{
  auto const s = cases::valve_sheet(history(), facts());
  EXPECT_NEAR(s.pilot_opens, 0.01 + 0.01 * 0.005, step / 2);
  EXPECT_NEAR(s.opens, 0.012 + tau * std::log(102.0 / 99), step / 2);
  EXPECT_NEAR(s.chamber_final, 160e3, 160);
  EXPECT_NEAR(s.chamber_time, 0.01 + tau * std::log(140 / (0.05 * 160)) - s.pilot_opens, step / 2);
  EXPECT_NEAR(s.flow_final, open_flow, 1e-3 * open_flow);
  EXPECT_NEAR(s.flow_rise, tau * std::log(9.0), step / 2);
  EXPECT_NEAR(s.gap_final, 100e-6, 1e-7);
  EXPECT_NEAR(s.gap_largest, 100e-6, 1e-7);
  EXPECT_NEAR(s.kv, 0.1155, 0.00015);
  EXPECT_NEAR(s.pressure_least, -20e3, 20);
  EXPECT_NEAR(s.cavitation, (101325 - 2339) / 300e3, 1e-3);
  EXPECT_EQ(s.leak, 0);
  EXPECT_EQ(s.leak_class, 5);
}

TEST(ValveFigures, SayNothingOfWhatTheRunDidNotReach)
{
  auto const shut = cases::valve_sheet(history(0.009, 1e-9), facts());
  EXPECT_TRUE(std::isnan(shut.pilot_opens));
  EXPECT_TRUE(std::isnan(shut.opens));
  EXPECT_TRUE(std::isnan(shut.flow_rise));
  EXPECT_TRUE(std::isnan(shut.chamber_time));
  EXPECT_NEAR(shut.leak, 1e-9, 1e-15);
  EXPECT_TRUE(std::isnan(shut.leak_class));  // no flow of the open valve to compare with
  EXPECT_EQ(cases::valve_text(shut).find("nan"), std::string::npos);
  EXPECT_NE(cases::valve_text(shut).find("leaves its seat at                 never"),
            std::string::npos);

  auto early = facts();
  early.pilot_opens = 0.02;  // given, in the place of the lift's
  EXPECT_EQ(cases::valve_sheet(history(), early).pilot_opens, 0.02);
}

TEST(ValveFigures, LeakClassesHaveTheLimitsOfTheStandard)
{
  // V: 5e-4 ml/min for an inch and a psi.
  double const least = 5e-4 * 1e-6 / 60;
  EXPECT_EQ(cases::leak_class(0.99 * least, 6894.76, 0, 25.4e-3), 5);
  EXPECT_TRUE(std::isnan(cases::leak_class(1.01 * least, 6894.76, 0, 25.4e-3)));
  EXPECT_EQ(cases::leak_class(0.9e-4, 1e5, 1, 0), 4);
  EXPECT_EQ(cases::leak_class(1.1e-4, 1e5, 1, 0), 3);
  EXPECT_EQ(cases::leak_class(-1.1e-3, 1e5, 1, 0), 2);
  EXPECT_EQ(cases::leak_class(6e-3, 1e5, 1, 0.01), 1);
  EXPECT_EQ(cases::valve_sheet(history(0.15, 0.5e-4 * open_flow), facts()).leak_class, 4);
}

TEST(ValveFigures, HaveNamesOfTheirOwn)
{
  auto const all = cases::valve_figures(history(), facts());
  EXPECT_EQ(all.size(), 17);
  for (auto const& figure : all) EXPECT_TRUE(figure.name.starts_with("valve_")) << figure.name;
  EXPECT_NE(core::to_json({all, {}}).find("\"valve_kv\""), std::string::npos);
}

}  // namespace
}  // namespace velum
