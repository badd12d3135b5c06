// problem:   a uniform inflow into a plane slit of 4 and 8 cells whose walls lie at 0, 0.2, ... 0.8
//            of a cell, 10 slit heights long
// reference: what flows in flows out; friction of the developed flow, 12 mu U / h^2, of the water
//            that the cells carry: half a cell beside a wall on cell centres belongs to no cell
// measure:   outflow over inflow; pressure over the last half of the slit, between the ends
// tolerance: outflow 1 %; friction 2.5 % at 4 cells, 1 % at 8
// why:       an interpolated wall loses mass where the stream turns, which it does most in the
//            corner that a uniform inflow makes with a wall at rest; there walls are half-way
//            (cases/app/lattice_scene.cpp) and lose none. What is left is lost behind them
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "tests/cases/flow_file.hpp"

namespace velum::tests {
namespace {

/// The shipped slit with a uniform inflow, 10 heights long.
/// @param offset  of the walls against the cells, cells
core::Summary slit(int cells, double offset)
{
  double const dx = 25, low = offset * dx, high = low + cells * dx, middle = (low + high) / 2;
  auto const point = [](double x, double y) { return fmt::format("[{} um, {} um]", x, y); };
  auto const patch = [&](char const* side) {
    return fmt::format("[{{ side = \"{}\", from = \"{} um\", to = \"{} um\" }}]", side, low, high);
  };
  std::vector<std::string> const set = {"lattice.from=" + point(0, -50),
                                        "lattice.to=" + point(10 * cells * dx, (cells + 3) * dx),
                                        "solid.floor.from=" + point(-100, -100),
                                        "solid.floor.to=" + point(9000, low),
                                        "solid.ceiling.from=" + point(-100, high),
                                        "solid.ceiling.to=" + point(9000, high + 100),
                                        "inlet.patches=" + patch("x-"),
                                        "outlet.patches=" + patch("x+"),
                                        "probe.friction.from=" + point(5 * cells * dx, middle),
                                        "probe.friction.to=" + point(8 * cells * dx, middle)};
  return cases::march_fluid(cases::read_scene("cases/slit/scene.toml", set),
                            {.out = {}, .quiet = true});
}

TEST(Inflow, BesideWallsBetweenCellsArrives)
{
  for (int cells : {4, 8})
    for (double offset : {0.0, 0.2, 0.4, 0.5, 0.6, 0.8}) {
      SCOPED_TRACE(fmt::format("{} cells, walls at {}", cells, offset));
      auto const run = slit(cells, offset);
      double const outflow = -figure(run, "outlet_1_flow") / 0.2e-6, h = cells * 25e-6;
      double const friction = 12 * 1e-3 * 0.2e-6 / std::pow(h, 3) * 3 * h;
      double const strip = offset == 0.5 ? 0.5 / cells : 0;  // 2 (3 s^2 - 2 s^3) of the flow
      double const carried = 1 - 2 * (3 * strip * strip - 2 * std::pow(strip, 3));
      EXPECT_NEAR(outflow, 1, 0.01);
      EXPECT_NEAR(carried * figure(run, "friction_pressure_difference") / friction, 1,
                  cells == 4 ? 0.025 : 0.01);
    }
}

}  // namespace
}  // namespace velum::tests
