// problem:   a port of the lattice whose opening has a traction of 5 and cells at 3 before it; one
//            that is shut for a while, as the edge of a gap is where the gap closes
// reference: the mean of this step's and the last one's; of a port of cells that of the cells;
//            after a pause nothing of what was there before it
// measure:   the port's pressure, and its impedance rho c_s / area
// tolerance: none
// why:       a statement about which number is taken
#include <gtest/gtest.h>

#include <cmath>

#include "ibm/chambers.hpp"

namespace velum::ibm {
namespace {

Chambers with_port(bool of_cells)
{
  Chambers c;
  c.network.ports = {{}};
  c.ports = {{{0}, 0, of_cells}};
  return c;
}

struct Step {
  structure::Membrane membrane =
      structure::flat_membrane({core::Symmetry::axisymmetric, 0, 1, 0.5, [](double) { return 0.1; },
                                structure::neo_hookean_rubber(1), 1});
  std::vector<lbm::Opening> openings{1};

  /// Pressure of the port in a step whose opening has that area, traction and cells before it.
  double operator()(Chambers& c, double area, double traction, double before)
  {
    openings[0].area = area;
    openings[0].traction = traction;
    openings[0].before = before;
    begin_step(c, openings, membrane, nullptr);
    return c.network.ports[0].pressure;
  }
};

TEST(LatticePort, takes_the_traction_or_the_pressure_of_the_cells)
{
  for (bool of_cells : {false, true}) {
    auto c = with_port(of_cells);
    Step step;
    step.openings[0].last_traction = 1;
    EXPECT_EQ(step(c, 2, 5, 3), of_cells ? 2 : 3);
    EXPECT_EQ(step(c, 2, 7, 9), 6);  // (3 + 9) / 2, (5 + 7) / 2
    EXPECT_DOUBLE_EQ(c.network.ports[0].impedance, 1 / std::sqrt(3.0) / 2);
  }
}

TEST(LatticePort, that_comes_back_forgets_what_was_before)
{
  auto c = with_port(true);
  Step step;
  step(c, 2, 5, 3);
  step(c, 0, 5, 100);
  EXPECT_EQ(step(c, 2, 5, 7), 7);
  EXPECT_EQ(step(c, 2, 5, 9), 8);
}

}  // namespace
}  // namespace velum::ibm
