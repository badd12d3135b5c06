#include "cases/app/geometry.hpp"
#include "tests/cases/scene_file.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

std::filesystem::path const shipped =
    std::filesystem::path(__FILE__).parent_path() / "../../cases/closed_valve/scene.toml";

TEST(Scene, ValuesArriveInSiUnits)
{
  auto const scene = read_text(small_valve);
  EXPECT_EQ(scene.name, "small_valve");
  EXPECT_EQ(scene.fidelity, cases::Fidelity::axisymmetric);
  EXPECT_DOUBLE_EQ(scene.lattice.dx, 1e-4);
  EXPECT_DOUBLE_EQ(scene.lattice.from[0], -4e-3);
  EXPECT_DOUBLE_EQ(scene.lattice.to[1], 6e-3);
  EXPECT_DOUBLE_EQ(scene.fluid.viscosity, 1e-6);
  EXPECT_DOUBLE_EQ(structure::shear_modulus(scene.materials.at("rubber").rubber), 1e6);
  EXPECT_DOUBLE_EQ(scene.materials.at("rubber").damping_stiffness, 5e-3);
  EXPECT_DOUBLE_EQ(cases::value_at(scene.membrane->thickness, 1e-3), 2e-3);
  ASSERT_EQ(scene.boundaries.size(), 2u);
  EXPECT_EQ(scene.boundaries[0].name, "inlet");
  EXPECT_DOUBLE_EQ(cases::value_at(scene.boundaries[0].value, 1.0), 5e4);
  EXPECT_DOUBLE_EQ(scene.boundaries[0].patches[0].to[0], 5e-3);
  EXPECT_DOUBLE_EQ(scene.run.end, 1e-2);
}

TEST(Scene, WhatIsLeftOutTakesItsDefault)
{
  auto const scene = read_text(small_valve);
  EXPECT_DOUBLE_EQ(scene.lattice.mach, 0.1);
  EXPECT_FALSE(scene.lattice.time_step);
  EXPECT_EQ(scene.lattice.collision, cases::Collision::central_moments);
  EXPECT_DOUBLE_EQ(scene.lattice.magic, 0.125);
  EXPECT_EQ(scene.les.model, cases::LesModel::auto_);
  EXPECT_DOUBLE_EQ(scene.les.constant, 0.1);
  EXPECT_DOUBLE_EQ(scene.membrane->element, scene.lattice.dx);
  EXPECT_EQ(scene.membrane->rim, cases::Rim::clamped);
  EXPECT_FALSE(scene.contact->stiffness);
  EXPECT_EQ(scene.coupling.method, cases::CouplingMethod::sharp);
  EXPECT_EQ(scene.coupling.scheme, cases::CouplingScheme::implicit);
  EXPECT_DOUBLE_EQ(cases::value_at(scene.boundaries[1].value, 0.0), 0.0);
}

TEST(Scene, TablesOverTimeAndRadiusAreStraightBetweenTheirRows)
{
  auto const scene =
      read_text(small_valve,
                {"inlet.pressure=[[0 ms, 0 kPa], [5 ms, 100 kPa]]",
                 "membrane.thickness=[[0 mm, 2 mm], [5 mm, 1 mm]]", "membrane.centre.radius=1 mm",
                 "membrane.centre.displacement=[[0 ms, 0 mm], [1 ms, -1 mm]]"});
  auto const& pressure = scene.boundaries[0].value;
  EXPECT_DOUBLE_EQ(cases::value_at(pressure, -1.0), 0);
  EXPECT_DOUBLE_EQ(cases::value_at(pressure, 2.5e-3), 5e4);
  EXPECT_DOUBLE_EQ(cases::value_at(pressure, 1.0), 1e5);
  EXPECT_DOUBLE_EQ(cases::value_at(scene.membrane->thickness, 2.5e-3), 1.5e-3);
  EXPECT_DOUBLE_EQ(cases::value_at(scene.membrane->centre->displacement, 5e-4), -5e-4);
}

TEST(Scene, EveryKeyOfTheShippedValveIsAccepted)
{
  auto const scene = cases::read_scene(shipped);
  EXPECT_EQ(scene.name, "closed_valve");
  ASSERT_TRUE(scene.membrane && scene.membrane->spring && scene.contact);
}

TEST(Scene, FurtherBoundariesAreReadByName)
{
  auto const scene = read_text(small_valve +
                               "[boundary.bleed]\nkind = \"flow_rate\"\nflow_rate = \"36 l/h\"\n"
                               "patches = [{ side = \"x+\", from = \"0 mm\", to = \"1 mm\" }]\n");
  auto const* bleed = cases::find_boundary(scene, "bleed");
  ASSERT_TRUE(bleed);
  EXPECT_EQ(bleed->kind, cases::BoundaryKind::flow_rate);
  EXPECT_DOUBLE_EQ(cases::value_at(bleed->value, 0.0), 1e-5);
}

TEST(Scene, ContourMayRepeatItsFirstPoint)
{
  auto const scene = read_text(
      edited(small_valve, R"(["-5 mm", "3 mm"]])", R"(["-5 mm", "3 mm"], ["-1.2 mm", "3 mm"]])"));
  EXPECT_EQ(cases::find_solid(scene, "seat")->points.size(), 4u);
}

TEST(Scene, SolidsAreShiftedUnitedAndSubtracted)
{
  auto const scene = read_text(small_valve +
                                   "[solid.port]\nshape = \"box\"\noperation = \"subtract\"\n"
                                   "from = [\"-1 mm\", \"5.5 mm\"]\nto = [\"1 mm\", \"6 mm\"]\n",
                               {"solid.seat.shift=[\"50 um\", \"0 um\"]"});
  auto const seat = cases::solid(scene, "seat");
  EXPECT_NEAR(core::distance(seat, {-1.15e-3, 3.2e-3}), 0, 1e-15);
  auto const all = cases::all_solids(scene);
  EXPECT_LT(core::distance(all, {-2e-3, 3.2e-3}), 0);
  EXPECT_LT(core::distance(all, {0, 5.2e-3}), 0);
  EXPECT_GT(core::distance(all, {0, 5.7e-3}), 0);
  EXPECT_NEAR(cases::initial_gap(scene), 0.15e-3, 1e-15);
}

TEST(Scene, TextAsRunReadsBackTheSame)
{
  auto const scene = read_text(small_valve, {"inlet.pressure=70 kPa", "lattice.mach=0.05"});
  auto const again = read_text(scene.source.text);
  EXPECT_EQ(again.source.text, scene.source.text);
  EXPECT_DOUBLE_EQ(cases::value_at(again.boundaries[0].value, 0.0), 7e4);
  EXPECT_DOUBLE_EQ(again.lattice.mach, 0.05);
}

}  // namespace
}  // namespace velum::tests
