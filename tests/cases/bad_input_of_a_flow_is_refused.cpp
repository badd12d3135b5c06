#include "tests/cases/flow_file.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

std::string refused(std::string const& old, std::string const& by)
{
  return refusal(edited(small_flow, old, by));
}

std::string periodic_box()
{
  return R"(name = "box"
fidelity = "planar"
[lattice]
dx = "1 mm"
from = ["0 mm", "0 mm"]
to = ["20 mm", "20 mm"]
periodic = ["x", "y"]
[fluid]
density = "1000 kg/m3"
viscosity = "1e-5 m2/s"
[initial]
kind = "taylor_green"
velocity = "10 mm/s"
[run]
end = "1 s"
)";
}

TEST(BadFlow, TheSmallFlowsThemselvesAreAccepted)
{
  EXPECT_EQ(refusal(small_flow), "");
  EXPECT_EQ(refusal(periodic_box()), "");
}

TEST(BadFlow, PeriodicTakesOnlyTheTwoAxesOnce)
{
  auto const box = periodic_box();
  EXPECT_EQ(refusal(edited(box, "[\"x\", \"y\"]", "[\"x\", \"z\"]")),
            "scene.toml:7: lattice.periodic holds the text \"z\". It must be an array with any of "
            "\"x\", \"y\".");
  EXPECT_EQ(refusal(edited(box, "[\"x\", \"y\"]", "[\"x\", \"x\"]")),
            "scene.toml:7: lattice.periodic holds \"x\" twice.");
  EXPECT_EQ(refusal(edited(box, "[\"x\", \"y\"]", "\"x\"")),
            "scene.toml:7: lattice.periodic must be an array with any of \"x\", \"y\", but is the "
            "text \"x\".");
}

TEST(BadFlow, PeriodicSideHoldsWholeCells)
{
  EXPECT_EQ(refusal(edited(periodic_box(), "dx = \"1 mm\"", "dx = \"1.5 mm\"")),
            "scene.toml:4: lattice.dx = 1.5 mm does not divide the periodic side of 20 mm; "
            "\"1.42857 mm\" would.");
  EXPECT_EQ(refusal(with(periodic_box(), "[chart]\ndx = [\"1 mm\", \"3 mm\"]")),
            "scene.toml:17: chart.dx[1] = 3 mm does not divide the periodic side of 20 mm; "
            "\"2.85714 mm\" would.");
}

TEST(BadFlow, PeriodicSideHasNoBoundaryAndNoRadius)
{
  EXPECT_EQ(
      refused("to = [\"40 mm\", \"20 mm\"]\n", "to = [\"40 mm\", \"20 mm\"]\nperiodic = [\"x\"]\n"),
      "scene.toml:21: inlet.patches[0].side = \"x-\" is a periodic side; it has no boundary.");
  EXPECT_EQ(refusal(edited(edited(periodic_box(), "planar", "axisymmetric"),
                           "[initial]\nkind = \"taylor_green\"\nvelocity = \"10 mm/s\"\n", "")),
            "scene.toml:7: lattice.periodic cannot hold \"y\", the radius of an axisymmetric "
            "scene.");
}

TEST(BadFlow, InitialFlowHasItsKeysAndNeedsAPeriodicBox)
{
  EXPECT_EQ(refusal(edited(periodic_box(), "taylor_green", "taylor_gren")),
            "scene.toml:12: initial.kind cannot be the text \"taylor_gren\"; did you mean "
            "\"taylor_green\"? Allowed: rest, uniform, taylor_green, "
            "shear_layer.");
  EXPECT_EQ(refusal(edited(periodic_box(), "velocity = \"10 mm/s\"", "steepness = 80")),
            "scene.toml:13: initial.steepness is not a key of [initial] with kind = "
            "\"taylor_green\". Allowed: kind, velocity.");
  EXPECT_EQ(refusal(edited(periodic_box(), "[\"x\", \"y\"]", "[\"x\"]")),
            "scene.toml:12: initial.kind = \"taylor_green\" needs lattice.periodic = [\"x\", "
            "\"y\"].");
}

TEST(BadFlow, MovingWallSlidesAlongASideOfTheBox)
{
  std::string const wall = "[boundary.lid]\nkind = \"moving_wall\"\nvelocity = \"1 mm/s\"\n";
  EXPECT_EQ(refusal(with(small_flow, wall + "patches = [{ side = \"y+\", from = \"0 mm\", to = "
                                            "\"40 mm\" }]")),
            "");
  EXPECT_EQ(refusal(with(small_flow, wall + "patches = [{ side = \"post\", from = \"8 mm\", to = "
                                            "\"12 mm\" }]")),
            "scene.toml:35: boundary.lid.patches[0].side = \"post\" is a solid; a moving wall lies "
            "on a side of the box: x-, x+, y- or y+.");
  EXPECT_EQ(refusal(with(small_flow,
                         "[boundary.lid]\nkind = \"moving_wall\"\npressure = \"1 "
                         "Pa\"\n")),
            "scene.toml:34: boundary.lid.pressure is not a key of [boundary.lid] with kind = "
            "\"moving_wall\". Allowed: kind, velocity, patches.");
}

TEST(BadFlow, ProfileIsAWordOfOpeningsWithAVelocity)
{
  EXPECT_EQ(refused("\"parabolic\"", "\"parabola\""),
            "scene.toml:19: inlet.profile cannot be the text \"parabola\"; did you mean "
            "\"parabolic\"? Allowed: uniform, parabolic.");
  EXPECT_EQ(refused("kind = \"outflow\"", "kind = \"outflow\"\nprofile = \"parabolic\""),
            "scene.toml:23: outlet.profile is not a key of [outlet] with kind = \"outflow\". "
            "Allowed: kind, pressure, patches.");
}

TEST(BadFlow, BodyForceIsAnAcceleration)
{
  auto const sentence = refused("viscosity = \"1e-5 m2/s\"\n",
                                "viscosity = \"1e-5 m2/s\"\nbody_force = [\"1 N\", \"0 m/s2\"]\n");
  EXPECT_TRUE(
      sentence.starts_with("scene.toml:10: fluid.body_force[0]: \"1 N\" is a force, and an "
                           "acceleration is expected"))
      << sentence;
}

TEST(BadFlow, ProbeLiesInTheFluidOrNamesASolid)
{
  EXPECT_EQ(refused("at = [\"30 mm\", \"10 mm\"]", "at = [\"41 mm\", \"10 mm\"]"),
            "scene.toml:26: probe.middle.at = (41, 10) mm is outside the domain.");
  EXPECT_EQ(refused("at = [\"30 mm\", \"10 mm\"]", "at = [\"12 mm\", \"10 mm\"]"),
            "scene.toml:26: probe.middle.at = (12, 10) mm is inside a solid.");
  EXPECT_EQ(refused("solid = \"post\"", "solid = \"pots\""),
            "scene.toml:29: probe.post.solid = \"pots\" names no solid of the scene; did you mean "
            "\"post\"?");
  EXPECT_EQ(refusal(small_flow, {"probe.mid.at=[1 mm, 1 mm]"}),
            "--set: probe.mid does not exist; the scene has middle or post.");
}

TEST(BadFlow, SteadyIsAShare)
{
  EXPECT_EQ(refused("end = \"2 s\"", "end = \"2 s\"\nsteady = 1.5"),
            "scene.toml:32: run.steady must be below 1, but is 1.5.");
}

TEST(BadFlow, ReferenceFitsTheScene)
{
  std::string const file = "kind = \"points\"\nfile = \"ref.csv\"\nlength = \"6 mm\"";
  EXPECT_EQ(refusal(with(small_flow, "[reference]\n" + file)),
            "scene.toml:34: reference.file = \"ref.csv\" is not a file beside the scene.");
  EXPECT_EQ(refusal(with(small_flow, "[reference]\nkind = \"points\"\nfile = \"a/ref.csv\"\n")),
            "scene.toml:34: reference.file must be the name of a file in the folder of the scene, "
            "without slashes.");
  EXPECT_EQ(refusal(with(small_flow, "[reference]\nkind = \"taylor_green\"")),
            "scene.toml:33: reference.kind = \"taylor_green\" needs a plane scene with "
            "initial.kind = \"taylor_green\", whose decay it compares with.");
  EXPECT_EQ(refusal(with(small_flow, "[reference]\nkind = \"pipe\"\nradius = \"1 mm\"")),
            "scene.toml:33: reference.kind = \"pipe\" needs lattice.periodic = [\"x\"], a "
            "fluid.body_force along x, and an axisymmetric scene from the axis on or a 3d one.");
}

TEST(BadFlow, WhatOnlyAFlowHasIsRefusedBesideAMembrane)
{
  EXPECT_EQ(refusal(with(small_valve, "steady = 1e-6")),
            "scene.toml:42: run.steady is for scenes without a membrane; this one has one.");
  EXPECT_EQ(refusal(with(small_valve, "[probe.p]\nkind = \"point\"\nat = [\"0 mm\", \"1 mm\"]")),
            "scene.toml:42: probe is for scenes without a membrane; this one has one.");
  EXPECT_EQ(refusal(edited(small_valve, "[inlet]\nkind = \"traction\"\npressure = \"50 kPa\"",
                           "[inlet]\nkind = \"moving_wall\"\nvelocity = \"1 m/s\"")),
            "scene.toml:18: inlet.kind is for scenes without a membrane; this one has one.");
}

}  // namespace
}  // namespace velum::tests
