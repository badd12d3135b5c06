#include "cases/app/derived.hpp"
#include "cases/app/preflight.hpp"
#include "tests/cases/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velum::tests {
namespace {

// problem:    numbers derived from the small valve at 50 kPa, Mach 0.1, dx 0.1 mm, water
// reference:  u = sqrt(2 p / rho) = 10 m/s; c_s = u / Ma = 100 m/s; dt = dx / (sqrt 3 c_s);
//             tau - 1/2 = 3 nu dt / dx^2; density jump p / (rho c_s^2) = Ma^2 / 2 = 0.5 %
// measure:    relative difference
// tolerance:  1e-12
// why:        a handful of exact operations in double precision
TEST(Derived, FlowNumbers)
{
  auto const d = cases::derive(read_text(small_valve));
  double const dt = 1e-4 / (std::sqrt(3.0) * 100);
  EXPECT_NEAR(d.velocity, 10, 1e-11);
  EXPECT_NEAR(d.sound_speed, 100, 1e-10);
  EXPECT_NEAR(d.mach, 0.1, 1e-13);
  EXPECT_NEAR(d.units.dt / dt, 1, 1e-12);
  EXPECT_NEAR(d.tau_minus_half / (3 * 1e-6 * dt / 1e-8), 1, 1e-12);
  EXPECT_NEAR(d.cell_reynolds, 1000, 1e-9);
  EXPECT_NEAR(d.density_jump, 0.005, 1e-14);
  EXPECT_EQ(d.grid.nx, 60);
  EXPECT_EQ(d.grid.ny, 60);
  EXPECT_EQ(d.steps, static_cast<std::int64_t>(std::ceil(1e-2 / dt)));
  EXPECT_NEAR(d.mass_ratio, 1100 * 2e-3 / (1000 * 1e-4), 1e-12);
}

TEST(Derived, GivenTimeStepReplacesTheMachNumber)
{
  auto const d = cases::derive(read_text(small_valve, {"lattice.time_step=1 us"}));
  EXPECT_DOUBLE_EQ(d.units.dt, 1e-6);
  EXPECT_NEAR(d.mach, 10 * std::sqrt(3.0) * 1e-6 / 1e-4, 1e-12);
}

TEST(Derived, VelocityComesFromWhateverDrives)
{
  EXPECT_NEAR(cases::reference_velocity(
                  read_text(small_valve, {"inlet.pressure=[[0 ms, 0 kPa], [5 ms, 200 kPa]]"})),
              20, 1e-11);
  auto const flow = read_text(edited(edited(small_valve, "\"traction\"", "\"flow_rate\""),
                                     "pressure = \"50 kPa\"", "flow_rate = \"1 l/s\""));
  EXPECT_NEAR(cases::reference_velocity(flow), 1e-3 / (M_PI * (25e-6 - 1e-6)), 1e-11);
  auto const moved =
      read_text(small_valve, {"inlet.pressure=0 Pa", "membrane.centre.radius=1 mm",
                              "membrane.centre.displacement=[[0 ms, 0 mm], [2 ms, 1 mm]]"});
  EXPECT_NEAR(cases::reference_velocity(moved), 0.5, 1e-12);
}

// problem:    stable step of the flat membrane with equal elements of length l
// reference:  2 / omega with omega = 2 c / l, c = sqrt(4 mu / rho_s): the wave crosses an element
// measure:    ratio of the derived step to l / c
// tolerance:  between 0.8 and 1
// why:        hoop stiffness near the axis lowers the limit by a share that the element size sets
TEST(Derived, StructureStepIsTheElementsWaveTransit)
{
  auto const scene = read_text(small_valve);
  double const transit = 1e-4 / std::sqrt(4 * 1e6 / 1100.0);
  double const ratio = cases::derive(scene).structure_step / transit;
  EXPECT_GT(ratio, 0.8);
  EXPECT_LE(ratio, 1.0);
}

cases::Verdict verdict(cases::Scene const& scene, std::string const& name)
{
  auto const derived = cases::derive(scene);
  auto rows = cases::fluid_rows(scene, derived);
  for (auto const& more :
       {cases::membrane_rows(scene, derived), cases::cost_rows(scene, derived, 10)})
    rows.insert(rows.end(), more.begin(), more.end());
  auto const found = std::find_if(rows.begin(), rows.end(),
                                  [&](auto const& row) { return row.name.starts_with(name); });
  if (found == rows.end()) throw std::logic_error("no row " + name);
  if (found->verdict == cases::Verdict::red && found->remark.empty())
    throw std::logic_error("a red row has to say what mends it");
  return found->verdict;
}

TEST(Preflight, RedLinesAppearWhereTheRunWouldFail)
{
  using cases::Verdict;
  auto const with = [](std::vector<std::string> const& set) { return read_text(small_valve, set); };
  EXPECT_EQ(verdict(with({}), "relaxation time"), Verdict::ok);
  EXPECT_EQ(verdict(with({"lattice.collision=bgk"}), "relaxation time"), Verdict::red);
  EXPECT_EQ(verdict(with({}), "mass ratio"), Verdict::ok);
  EXPECT_EQ(verdict(with({"coupling.scheme=explicit"}), "mass ratio"), Verdict::red);
  EXPECT_EQ(verdict(with({"lattice.mach=0.6"}), "Mach"), Verdict::red);
  EXPECT_EQ(verdict(with({"lattice.mach=0.3"}), "Mach"), Verdict::warn);
  EXPECT_EQ(verdict(with({}), "cells in the smallest gap"), Verdict::warn);
  EXPECT_EQ(verdict(with({"solid.seat.shift=[0.5 mm, 0 mm]"}), "cells in the smallest gap"),
            Verdict::red);
  EXPECT_EQ(verdict(with({"membrane.thickness=0.05 mm"}), "cells across the membrane"),
            Verdict::red);
  EXPECT_EQ(verdict(with({"run.end=1000 s"}), "time to finish"), Verdict::red);
}

}  // namespace
}  // namespace velum::tests
