// problem:   a block in a duct in space, once as a box, once as the STL file of that box beside the
//            scene; an STL file with a hole
// reference: each other
// measure:   the drag on the block after some hundred steps, and its velocity beside it
// tolerance: 1e-9; a hole is refused
// why:       the distance from a closed mesh is exact, the corners lie on whole numbers that single
//            precision holds: only round-off in the distances of the links differs
#include <gtest/gtest.h>

#include "tests/cases/flow_file.hpp"
#include "tests/core/stl_files.hpp"

namespace velum::tests {
namespace {

std::string const duct = box_in_space + "[solid.block]\n";
std::string const as_box = R"(shape = "box"
from = ["5.3 mm", "2.6 mm", "3 mm"]
to = ["8.4 mm", "7 mm", "6.7 mm"]
)";
std::string const as_file = R"(shape = "stl"
file = "block.stl"
unit = "0.1 mm"
)";
std::string const rest_of_duct = R"([inlet]
kind = "flow_rate"
flow_rate = "1e-6 m3/s"
patches = [{ side = "x-", centre = ["5 mm", "5 mm"], radius = "4 mm" }]
profile = "parabolic"
[outlet]
kind = "outflow"
patches = [{ side = "x+", from = ["1 mm", "1 mm"], to = ["9 mm", "9 mm"] }]
[probe.block]
kind = "force"
solid = "block"
[probe.beside]
kind = "point"
at = ["7 mm", "8.5 mm", "5 mm"]
[run]
end = "0.2 s"
)";

struct Figures {
  double force, velocity;
};

Figures run_duct(std::string const& solid, Facets const& facets)
{
  TemporaryFolder const folder;
  write(folder.path / "block.stl", binary_stl(facets));
  auto const file = write(folder.path / "scene.toml", duct + solid + rest_of_duct);
  auto const scene = cases::read_scene(file);
  auto const run = cases::march_fluid(scene, {.out = {}, .quiet = true});
  return {figure(run, "block_force_x"), figure(run, "beside_velocity_x")};
}

TEST(SolidFromStl, IsTheSolid)
{
  auto const facets = cuboid({53, 26, 30}, {84, 70, 67});
  auto const shape = run_duct(as_box, facets), file = run_duct(as_file, facets);
  EXPECT_GT(shape.force, 0);
  EXPECT_GT(shape.velocity, 0.01);
  EXPECT_NEAR(file.force / shape.force, 1, 1e-9);
  EXPECT_NEAR(file.velocity / shape.velocity, 1, 1e-9);
}

TEST(SolidFromStl, WithAHoleIsRefused)
{
  auto facets = cuboid({53, 26, 30}, {84, 70, 67});
  facets.pop_back();
  try {
    run_duct(as_file, facets);
    FAIL() << "a block without one of its triangles has no inside";
  } catch (core::InputError const& error) {
    std::string const sentence = error.what();
    EXPECT_NE(sentence.find("scene.toml:12: solid.block.file = \"block.stl\" is not the closed "
                            "surface of a solid: it has 3 open edges"),
              std::string::npos)
        << sentence;
  }
}

}  // namespace
}  // namespace velum::tests
