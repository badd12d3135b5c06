// problem:   parabolic and uniform openings in a channel and in a pipe, made by the scene
// reference: the scene's mean velocity times the area; 1.5 or 2 times the mean in the middle
// measure:   sum of the links' weights times their area; largest weight
// tolerance: flow 1e-6 (weights are stored as float); top 2 % with 20 cells across
// why:       the weights are scaled to the flow; the top is half a cell off the middle
#include <gtest/gtest.h>

#include "cases/app/lattice_scene.hpp"
#include "tests/cases/flow_file.hpp"

namespace velum::tests {
namespace {

struct Shape {
  double mean = 0, top = 0;
};

Shape shape(std::string const& text)
{
  auto const scene = read_text(text);
  auto const s = cases::make_lattice_scene<double>(scene, 0);
  auto const& inlet = s.openings.front();
  Shape shape;
  for (auto const& link : inlet.links) {
    double const weight = link.weight;
    shape.mean += weight * lbm::opening_area(s.fluid, {link}, inlet.opening.normal);
    shape.top = std::max(shape.top, weight);
  }
  shape.mean /= inlet.opening.area;
  return shape;
}

TEST(Profile, ParabolaHasItsMeanAndItsTop)
{
  auto const channel = shape(small_flow);
  EXPECT_NEAR(channel.mean, 1, 1e-6);
  EXPECT_NEAR(channel.top, 1.5, 0.03);
  auto const pipe = shape(edited(edited(small_flow, "planar", "axisymmetric"),
                                 "\"12 mm\", \"10 mm\"", "\"12 mm\", \"9 mm\""));
  EXPECT_NEAR(pipe.mean, 1, 1e-6);
  EXPECT_NEAR(pipe.top, 2, 0.04);
}

TEST(Profile, UniformIsOneEverywhere)
{
  auto const channel = shape(edited(small_flow, "parabolic", "uniform"));
  EXPECT_DOUBLE_EQ(channel.mean, 1);
  EXPECT_EQ(channel.top, 1);
}

TEST(Profile, TimeStepKnowsTheTopOfTheParabola)
{
  EXPECT_NEAR(cases::reference_velocity(read_text(small_flow)), 0.015, 1e-15);
  EXPECT_NEAR(cases::reference_velocity(read_text(edited(small_flow, "parabolic", "uniform"))),
              0.01, 1e-15);
}

}  // namespace
}  // namespace velum::tests
