// problem:   parabolic and uniform openings in a channel and in a pipe, made by the scene
// reference: the scene's mean velocity times the area; 1.5 or 2 times the mean in the middle
// measure:   sum of the links' weights times their area; largest weight
// tolerance: flow 1e-6 (weights are stored as float), between walls off the cells 2e-3; top 2 %
//            with 20 cells across
// why:       the area between such walls is sampled (cases/app/open_area.hpp); the weights are
// scaled to the flow; the top is half a cell off the middle
#include <gtest/gtest.h>

#include <fmt/format.h>

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

/// What comes in over what a mean velocity of 1 would bring through 8.3 of 20 cells.
double brought(std::string const& profile, char const* side, char const* other, bool along_y)
{
  auto const place = [&](double a, double b) {
    return along_y ? fmt::format("[\"{} mm\", \"{} mm\"]", b, a)
                   : fmt::format("[\"{} mm\", \"{} mm\"]", a, b);
  };
  std::string const text = fmt::format(R"(name = "duct"
fidelity = "planar"
[lattice]
dx = "1 mm"
from = ["0 mm", "0 mm"]
to = ["20 mm", "20 mm"]
[fluid]
density = "1000 kg/m3"
viscosity = "1e-5 m2/s"
[les]
model = "off"
[solid.low]
shape = "box"
from = {0}
to = {1}
[solid.high]
shape = "box"
from = {2}
to = {3}
[inlet]
kind = "velocity"
velocity = "10 mm/s"
profile = "{4}"
patches = [{{ side = "{5}", from = "5.4 mm", to = "13.7 mm" }}]
[outlet]
kind = "pressure"
pressure = "0 Pa"
patches = [{{ side = "{6}", from = "5.4 mm", to = "13.7 mm" }}]
[run]
end = "1 s"
)",
                                       place(-1, -1), place(21, 5.4), place(-1, 13.7),
                                       place(21, 21), profile, side, other);
  auto const s = cases::make_lattice_scene<double>(read_text(text), 0);
  auto const& inlet = s.openings.front();
  double flow = 0;
  for (auto const& link : inlet.links)
    flow += link.weight * lbm::opening_area(s.fluid, {link}, inlet.opening.normal);
  return flow / 8.3;
}

TEST(Profile, VelocityBringsItsMeanTimesTheTrueArea)
{
  for (char const* profile : {"uniform", "parabolic"}) {
    EXPECT_NEAR(brought(profile, "x-", "x+", false), 1, 2e-3) << profile;
    EXPECT_NEAR(brought(profile, "x+", "x-", false), 1, 2e-3) << profile;
    EXPECT_NEAR(brought(profile, "y-", "y+", true), 1, 2e-3) << profile;
    EXPECT_NEAR(brought(profile, "y+", "y-", true), 1, 2e-3) << profile;
  }
}

TEST(Profile, TimeStepKnowsTheTopOfTheParabola)
{
  EXPECT_NEAR(cases::reference_velocity(read_text(small_flow)), 0.015, 1e-15);
  EXPECT_NEAR(cases::reference_velocity(read_text(edited(small_flow, "parabolic", "uniform"))),
              0.01, 1e-15);
}

}  // namespace
}  // namespace velum::tests
