// problem:   the shipped scenes without a membrane, through the same code as `velum run`, on coarse
//            grids: lid-driven cavity, cylinder in a channel, Taylor-Green vortex, pipe, shear
//            layer; still water, slit, radial discs
// reference: the one that each scene names (its reference.csv or exact solution)
// measure:   the scene's own error figures; orders from three grids at velocities ~ dx
// tolerance: cavity 4 % L2 on 40 cells; drag 3 %, pressure difference 5 % with 10 cells across the
//            cylinder; orders at least 1.8, the vortex 1e-4 on 32 cells; shear layer 15 % on 64;
//            still water left with a tenth of its speed (it grew a million times); slit of 2, 3, 4
//            and 8 cells 1 %, discs 4 cells apart 2 % at Mach 0.03 and 0.003
// why:       second-order scheme and walls; the vortex's leading error is small and changes its
//            sign between these grids, so that its order comes out above 2; the cavity's table
//            itself is off by 1 %; ten cells are a tenth of the radius of curvature of the boundary
//            layer at the cylinder
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/check.hpp"
#include "tests/cases/flow_file.hpp"
#include "tests/support/order.hpp"

namespace velum::tests {
namespace {

TEST(ShippedFlow, LidCavityFollowsGhiaAndEndsWhenSteady)
{
  auto const run = run_shipped(
      "lid_cavity", {"lattice.dx=25 mm", "fluid.viscosity=1e-2 m2/s", "lattice.mach=0.15"});
  EXPECT_LT(figure(run, "error_l2"), 0.04);
  EXPECT_EQ(figure(run, "reference_values"), 30);
  EXPECT_LT(figure(run, "end_time"), 60);
  EXPECT_TRUE(run.assumptions.at("end").starts_with("steady at t = "));
  EXPECT_EQ(run.assumptions.at("reference"), "reference.csv for Re = 100");
}

TEST(ShippedFlow, LidCavityWithoutATableSaysSo)
{
  auto const run = run_shipped("lid_cavity", {"lattice.dx=62.5 mm", "fluid.viscosity=0.02 m2/s",
                                              "run.end=1 s", "run.steady=1e-9"});
  EXPECT_THROW(figure(run, "error_l2"), std::runtime_error);
  EXPECT_EQ(run.assumptions.at("reference"),
            "none: reference.csv has nothing for Re = 50 at the end of this run, only for 100, "
            "1000, 5000");
  EXPECT_TRUE(run.assumptions.at("end").starts_with("run.end reached"));
}

TEST(ShippedFlow, CylinderAtReynolds20HasThePublishedDrag)
{
  auto const run = run_shipped("cylinder_channel",
                               {"lattice.dx=10 mm", "run.end=20 s", "run.sample_every=0.1 s"});
  EXPECT_LT(figure(run, "drag_coefficient_error"), 0.03);
  EXPECT_LT(figure(run, "pressure_difference_error"), 0.05);
}

TEST(ShippedFlow, CylinderAtReynolds100ShedsAtThePublishedFrequency)
{
  auto const run =
      run_shipped("cylinder_channel", {"lattice.dx=5 mm", "inlet.velocity=1 m/s", "run.end=6 s"});
  EXPECT_LT(figure(run, "strouhal_error"), 0.01);
  EXPECT_LT(figure(run, "drag_coefficient_max_error"), 0.03);
  EXPECT_LT(figure(run, "lift_coefficient_max_error"), 0.05);
}

// The eddies are shear waves at 45 degrees. Where odd moments relax by magic = 1/8 the lattice's
// viscosity for these is 1.6/n^2 too small at n cells (the dispersion relation of the linear
// scheme; for waves along its axes it is exact), and the eddies die by 1/e: 2/n^2 leaves room for
// compressibility, as the Mach number falls with n. At rate 1 it is the other way round, 3.1/n^2
// along the axes and nothing at 45 degrees, which one orientation alone does not show.
TEST(ShippedFlow, TaylorGreenIsSecondOrder)
{
  for (int n : {8, 16, 32, 64}) {
    auto const run = run_shipped("taylor_green", {fmt::format("lattice.dx={} mm", 1e3 / n),
                                                  fmt::format("lattice.mach={}", 0.4 / n)});
    EXPECT_LT(figure(run, "error_l2"), 2.0 / (n * n)) << n;
  }
}

// The wall stands at the same share of a cell at each resolution: where it moves from one to the
// next the error's constant does too, and there is no order to see.
TEST(ShippedFlow, PipeIsSecondOrderWhereverItsWallStands)
{
  for (double share : {0.0, 0.3, 0.5, 0.8}) {
    std::vector<double> h, e;
    for (double dx : {2.0, 1.0, 0.5}) {
      double const radius = 10 - share * dx;
      auto const run = run_shipped(
          "pipe", {fmt::format("lattice.dx={} mm", dx), fmt::format("lattice.mach={}", 0.1 * dx),
                   fmt::format("solid.wall.from=[-10 mm, {} mm]", radius),
                   fmt::format("reference.radius={} mm", radius), "run.end=30 s"});
      h.push_back(dx);
      e.push_back(figure(run, "error_l2"));
    }
    EXPECT_GT(order(h, e), 1.8) << share << ": " << e[0] << " " << e[1] << " " << e[2];
    // where the wall is on centres of cells the error is twice that elsewhere
    EXPECT_LT(e.back(), share == 0.5 ? 4e-3 : 2e-3) << share;
  }
}

// What drives the fluid is what the wall holds back: momentum exchange against rho g V, exact but
// for what the flow is still short of steady.
TEST(ShippedFlow, ForceOnThePipeIsThatWhichDrivesTheFlow)
{
  auto const run = run_shipped("pipe", {"lattice.dx=1 mm", "lattice.mach=0.1"});
  double const volume = std::numbers::pi * 1e-4 * 8e-3;
  EXPECT_NEAR(figure(run, "wall_force_x") / (1000 * 0.008 * volume), 1, 1e-4);
}

TEST(ShippedFlow, ShearLayerRollsUpAsTheSpectralSolution)
{
  auto const run = run_shipped("shear_layer", {"lattice.dx=15.625 mm"});
  EXPECT_LT(figure(run, "error_l2"), 0.15);
  EXPECT_EQ(figure(run, "reference_values"), 2048);
}

TEST(ShippedFlow, SinglePrecisionIsAsGood)
{
  auto const whole = run_shipped("taylor_green", {"lattice.dx=31.25 mm"});
  auto const half =
      run_shipped("taylor_green", {"lattice.dx=31.25 mm", "lattice.precision=single"});
  EXPECT_NEAR(figure(half, "error_l2"), figure(whole, "error_l2"), 1e-4);
}

// The guard looks between the dumps: a run that is lost says so long before its end.
TEST(ShippedFlow, DivergenceIsCaughtBetweenTheDumps)
{
  try {
    run_shipped("shear_layer",
                {"lattice.dx=31.25 mm", "lattice.collision=bgk", "fluid.viscosity=1e-7 m2/s",
                 "run.end=100 s", "run.output_every=100 s"});
    FAIL() << "BGK at tau - 1/2 = 5e-8 should not survive this";
  } catch (core::Divergence const& lost) {
    std::string const sentence = lost.what();
    EXPECT_NE(sentence.find("Diverged at step"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("tau - 1/2"), std::string::npos) << sentence;
    int const step = std::stoi(sentence.substr(17));
    EXPECT_LT(step, 20000) << sentence;
  }
}

}  // namespace
// 82.5 cells under a wall: links of length zero, the ones that fed a wave along it.
TEST(ShippedFlow, StillWaterStaysStill)
{
  EXPECT_LT(figure(run_shipped("still_water", {}), "speed_max_error"), 0.1);
}

TEST(ShippedFlow, SlitOfFewCellsTakesItsPressure)
{
  for (auto const* dx : {"50 um", "33.3333 um", "25 um", "12.5 um"})
    EXPECT_LT(figure(run_shipped("slit", {std::string("lattice.dx=") + dx}),
                     "friction_pressure_difference_error"),
              0.01)
        << dx;
}

TEST(ShippedFlow, RadialDiscsDoNotKnowTheMachNumber)
{
  for (auto const* mach : {"0.03", "0.003"})
    EXPECT_LT(figure(run_shipped("radial_discs", {std::string("lattice.mach=") + mach}),
                     "land_pressure_difference_error"),
              0.02)
        << mach;
}

TEST(ShippedFlow, ReferenceToAFigureThatIsNotThereNamesThoseThatAre)
{
  auto const run =
      run_shipped("slit", {"reference.figure=friction_presure_difference", "run.end=1 ms"});
  EXPECT_TRUE(
      run.assumptions.at("reference")
          .starts_with(
              "none: this run has no figure friction_presure_difference; did you "
              "mean friction_pressure_difference? Some want a longer run. It has: speed_max, "))
      << run.assumptions.at("reference");
}

TEST(ShippedFlow, ATimeStepThatCannotBeMarchedIsRefused)
{
  auto const refusal = [](std::vector<std::string> const& set) -> std::string {
    try {
      run_shipped("slit", set);
    } catch (core::InputError const& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal({"lattice.time_step=1 s"}).find("run.end = 0.04 s does not hold one time step"),
            std::string::npos);
  EXPECT_NE(refusal({"lattice.time_step=15 ms"}).find("it must be below 1: lattice.time_step < "),
            std::string::npos);
}

}  // namespace velum::tests
