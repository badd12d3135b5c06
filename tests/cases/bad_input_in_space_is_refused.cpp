#include "tests/cases/flow_file.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

std::string const box = box_in_space + R"([solid.ball]
shape = "sphere"
centre = ["5 mm", "5 mm", "5 mm"]
radius = "2 mm"
[inlet]
kind = "velocity"
velocity = "10 mm/s"
patches = [{ side = "x-", centre = ["5 mm", "5 mm"], radius = "4 mm" }]
[outlet]
kind = "outflow"
patches = [{ side = "x+" }]
[boundary.belt]
kind = "moving_wall"
velocity = "10 mm/s"
along = "x"
patches = [{ side = "z+" }]
[run]
end = "1 s"
)";

std::string refused(std::string const& old, std::string const& by)
{
  return refusal(edited(box, old, by));
}

TEST(BadSpace, TheBoxItselfIsAccepted) { EXPECT_EQ(refusal(box), ""); }

TEST(BadSpace, PointsHaveThreeCoordinates)
{
  EXPECT_EQ(refused("from = [\"0 mm\", \"0 mm\", \"0 mm\"]", "from = [\"0 mm\", \"0 mm\"]"),
            "scene.toml:5: lattice.from must be three lengths, such as [\"1 mm\", \"1 mm\", \"1 "
            "mm\"], but is an array of 2 values.");
}

TEST(BadSpace, LatticeAndCollisionFitTheDimensions)
{
  EXPECT_EQ(refused("dx = \"1 mm\"", "dx = \"1 mm\"\nstencil = \"d2q9\""),
            "scene.toml:5: lattice.stencil cannot be \"d2q9\" in space; \"d3q19\" or \"d3q27\" "
            "can.");
  EXPECT_EQ(refused("dx = \"1 mm\"", "dx = \"1 mm\"\ncollision = \"cumulant\""),
            "scene.toml:5: lattice.collision = \"cumulant\" needs stencil = \"d3q27\", in a 3d "
            "scene.");
  EXPECT_EQ(refusal(edited(small_flow, "dx = \"1 mm\"", "dx = \"1 mm\"\nstencil = \"d3q19\"")),
            "scene.toml:5: lattice.stencil cannot be \"d3q19\" in a plane; only \"d2q9\" can.");
}

TEST(BadSpace, ShapesBelongToSpaceOrPlane)
{
  EXPECT_EQ(refused("shape = \"sphere\"", "shape = \"disc\""),
            "scene.toml:11: solid.ball.shape cannot be \"disc\" in space; \"sphere\" and "
            "\"cylinder\" can.");
  EXPECT_EQ(refusal(edited(small_flow, "shape = \"disc\"", "shape = \"sphere\"")),
            "scene.toml:13: solid.post.shape cannot be \"sphere\" in a plane; \"disc\" and "
            "\"profile\" can.");
  EXPECT_EQ(
      refused("shape = \"sphere\"\ncentre = [\"5 mm\", \"5 mm\", \"5 mm\"]\nradius = \"2 mm\"",
              "shape = \"stl\"\nfile = \"ball.stl\"\nunit = \"1 mm\"")
              .find("ball.stl") != std::string::npos,
      true);
}

TEST(BadSpace, PatchesLieOnSidesOfTheBox)
{
  EXPECT_EQ(refused("side = \"x+\"", "side = \"ball\""),
            "scene.toml:20: outlet.patches[0].from is missing; without it a patch is a whole side "
            "of the box, and \"ball\" is none.");
  EXPECT_EQ(refused("{ side = \"x-\", centre = [\"5 mm\", \"5 mm\"], radius = \"4 mm\" }",
                    "{ side = \"x-\", centre = [\"5 mm\", \"5 mm\"], radius = \"6 mm\" }"),
            "scene.toml:17: inlet.patches[0].radius = -1 mm is outside the domain, which goes from "
            "0 mm to 10 mm there.");
  EXPECT_EQ(refused("{ side = \"x-\", centre = [\"5 mm\", \"5 mm\"], radius = \"4 mm\" }",
                    "{ side = \"x-\", centre = [\"5 mm\", \"5 mm\"], to = [\"6 mm\", \"6 mm\"] }"),
            "scene.toml:17: inlet.patches[0].to is not a key of [inlet.patches[0]] with a disc. "
            "Allowed: side, centre, radius.");
}

TEST(BadSpace, WallsSlideAlongThemselves)
{
  EXPECT_EQ(refused("along = \"x\"", "along = \"z\""),
            "scene.toml:24: boundary.belt.along = \"z\" points through the wall \"z+\", which can "
            "only slide along itself.");
}

TEST(BadSpace, SidesAreOneThingOnly)
{
  EXPECT_EQ(refused("dx = \"1 mm\"", "dx = \"1 mm\"\nsymmetry = [\"z+\"]"),
            "scene.toml:26: boundary.belt.patches[0].side = \"z+\" is a plane of symmetry; it has "
            "no boundary.");
  EXPECT_EQ(refused("dx = \"1 mm\"", "dx = \"1 mm\"\nperiodic = [\"y\"]\nsymmetry = [\"y-\"]"),
            "scene.toml:6: lattice.symmetry holds \"y-\", a periodic side by lattice.periodic.");
}

TEST(BadSpace, MembranesAreForThePlane)
{
  EXPECT_EQ(refusal(with(box, "[membrane]\nshape = \"disc\"")),
            "scene.toml:28: membrane is for planar and axisymmetric scenes; in space velum has "
            "none yet.");
}

TEST(BadSpace, HalfPrecisionIsForScenesWithoutAMembrane)
{
  EXPECT_EQ(refusal(small_valve, {"lattice.precision=half"}),
            "--set: lattice.precision = \"half\" is for scenes without a membrane.");
}

}  // namespace
}  // namespace velum::tests
