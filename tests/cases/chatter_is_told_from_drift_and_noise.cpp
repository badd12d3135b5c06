// Problem: histories of gap, pressure difference and flow as a valve would write them, made from
//   formulas: a gap that opens, with an oscillation on it that lasts, grows, decays or is missing.
// Reference: the formulas.
// Measure: kind, onset, frequency, amplitude, rate, phases and contacts per cycle.
// Tolerance: frequency 0.5 %, phases 3 degrees, amplitude 5 %, rate 5 %, onset a period.
// Why: a designer compares frequencies with those of pipes and springs, known to a few per cent;
//   the amplitude is read between samples, some 20 a period, where a parabola misses little.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "cases/app/chatter.hpp"

namespace velum {
namespace {

using cases::ChatterKind;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double frequency = 287, amplitude = 12e-6, begins = 0.09;

struct Made {
  double rate = 0;           // of the amplitude
  double limit = amplitude;  // that it grows to
  double noise = 0;          // of the gap, m
  double end = 0.25;
  bool uneven = false;
  double middle = 60e-6;  // that the gap opens to
};

cases::ChatterSignals make(Made const& m)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  cases::ChatterSignals s;
  double const step = 0.17e-3;
  for (int k = 0; step * k <= m.end; ++k) {
    double const t = step * (k + (m.uneven && k > 0 ? uniform(random) : 0));
    double const since = t - begins;
    double const start = m.rate > 0 ? 0.1 * amplitude : m.limit;
    double const a = since < 0 ? 0 : std::min(m.limit, start * std::exp(m.rate * since));
    double const open = m.middle * (1 + std::tanh((t - 0.03) / 0.01)) / 2;
    auto const wave = [&](double degrees) {
      return a / amplitude * std::cos(two_pi * (frequency * since + degrees / 360));
    };
    s.time.push_back(t);
    s.gap.push_back(open + amplitude * wave(0) + m.noise * normal(random));
    s.pressure.push_back(300e3 * (1 - open / 200e-6) + 20e3 * wave(140));
    s.flow.push_back(5e-5 * open / m.middle + 4e-6 * wave(-25));
  }
  return s;
}

void expect_planted(cases::Chatter const& c)
{
  EXPECT_NEAR(c.frequency, frequency, 0.005 * frequency);
  EXPECT_NEAR(c.pressure_phase, 140, 3);
  EXPECT_NEAR(c.flow_phase, -25, 3);
  EXPECT_NEAR(c.flow_pressure, -165, 3);
  EXPECT_NEAR(c.onset, begins, 1 / frequency);
}

TEST(Chatter, LimitCycleHasThePlantedFrequencyAmplitudeAndPhases)
{
  for (bool const uneven : {false, true}) {
    auto const c = cases::find_chatter(make({.noise = 0.3e-6, .uneven = uneven}));
    ASSERT_EQ(c.kind, ChatterKind::limit_cycle);
    expect_planted(c);
    EXPECT_NEAR(c.amplitude, 2 * amplitude, 0.1 * amplitude);
    EXPECT_NEAR(c.end, 0.25, 1 / frequency);
    EXPECT_EQ(c.contacts_per_cycle, 0);
  }
}

TEST(Chatter, GrowingAndDecayingAreToldByTheSignOfTheirRate)
{
  auto const growing = cases::find_chatter(make({.rate = 14, .limit = 1}));
  ASSERT_EQ(growing.kind, ChatterKind::growing);
  EXPECT_NEAR(growing.rate, 14, 0.7);
  expect_planted(growing);

  auto const decaying = cases::find_chatter(make({.rate = -40}));
  ASSERT_EQ(decaying.kind, ChatterKind::decaying);
  EXPECT_NEAR(decaying.rate, -40, 2);
  expect_planted(decaying);
  EXPECT_NEAR(decaying.end, begins + std::log(amplitude / 1e-6) / 40, 1 / frequency);
  EXPECT_NEAR(decaying.largest, 2 * amplitude, 0.4 * amplitude);
}

TEST(Chatter, WhatHasGrownToItsLimitIsALimitCycle)
{
  auto const c = cases::find_chatter(make({.rate = 60}));
  EXPECT_EQ(c.kind, ChatterKind::limit_cycle);
  expect_planted(c);
}

TEST(Chatter, ContactsAreCountedInEveryCycle)
{
  auto s = make({.middle = 6e-6});
  for (double& gap : s.gap) gap = std::max(gap, -1e-7);  // the seat stops it
  auto const c = cases::find_chatter(s);
  ASSERT_EQ(c.kind, ChatterKind::limit_cycle);
  expect_planted(c);
  EXPECT_NEAR(c.contacts_per_cycle, 1, 0.05);
}

TEST(Chatter, AnOpeningAloneHasNone)
{
  EXPECT_EQ(cases::find_chatter(make({.limit = 0})).kind, ChatterKind::none);
  auto s = make({.limit = 0});
  for (std::size_t k = 0; k < s.time.size(); ++k) s.gap[k] = s.time[k] < 0.1 ? 0 : 80e-6;
  EXPECT_EQ(cases::find_chatter(s).kind, ChatterKind::none);
  for (std::size_t k = 0; k < s.time.size(); ++k)
    s.gap[k] = 90e-6 * (1 - std::exp(-std::max(0.0, s.time[k] - 0.05) / 0.01));
  EXPECT_EQ(cases::find_chatter(s).kind, ChatterKind::none);
  s.gap.assign(s.time.size(), -1.8e-6);
  EXPECT_EQ(cases::find_chatter(s).kind, ChatterKind::none);
}

TEST(Chatter, NoiseAloneIsNone)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 40; ++run) {
    auto s = make({});
    double red = 0;
    for (double& gap : s.gap) {
      red = 0.9 * red + normal(random);
      gap = 50e-6 + 1e-6 * (run % 2 ? 4 * normal(random) : 2 * red);
    }
    EXPECT_EQ(cases::find_chatter(s).kind, ChatterKind::none) << run;
  }
}

TEST(Chatter, ARecordThatIsTooShortSaysSo)
{
  auto const begun = cases::find_chatter(make({.end = begins + 2.6 / frequency}));
  EXPECT_EQ(begun.kind, ChatterKind::too_short);
  EXPECT_NE(cases::chatter_text(begun).find("too short"), std::string::npos);
  EXPECT_TRUE(std::isnan(cases::figures(begun).at(0).value));
  EXPECT_EQ(cases::find_chatter(make({.end = 3e-3})).kind, ChatterKind::too_short);
}

}  // namespace
}  // namespace velum
