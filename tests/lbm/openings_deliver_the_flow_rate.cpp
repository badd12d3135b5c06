// problem:   a flow-rate inlet into a tube with an outflow, from rest, planar and axisymmetric,
//            double and single precision
// reference: its mass flow, which is the volume per step at density 1; in the end it leaves again
// measure:   relative error of the mass flow, every step; of the outflow at the end
// tolerance: 1e-13 double, 1e-5 single; outflow 1 %
// why:       the half-way rule adds exactly 6 w c.n U per link, whatever the flow; single precision
//            loses digits where it adds that to a population. The outflow settles slowly
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"

namespace velum {
namespace {

template <class Real>
void expect_flow(core::Symmetry symmetry, double tolerance)
{
  int const nx = 40, ny = 12;
  bool const round = symmetry == core::Symmetry::axisymmetric;
  double const volume = 0.02 * (round ? std::acos(-1.0) * ny * ny : ny);
  auto flow = tests::make_flow(
      lbm::make_fluid<Real>(nx, ny, {0, 0}, symmetry,
                            {lbm::Collision::central_moments, 0.02, 1.0 / 8}),
      tests::no_solids(), tests::open_ends(nx),
      {{lbm::OpeningKind::flow_rate, {1, 0}, volume}, {lbm::OpeningKind::outflow, {-1, 0}, 0.0}});
  double worst = 0;
  for (int t = 0; t < 6000; ++t) {
    tests::step(flow);
    worst = std::max(worst, std::abs(flow.openings[0].mass_flow / volume - 1));
  }
  EXPECT_LT(worst, tolerance);
  EXPECT_NEAR(flow.openings[1].mass_flow / volume, -1, 0.01);
}

TEST(FlowRateInlet, DeliversItsFlow)
{
  for (auto symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
    expect_flow<double>(symmetry, 1e-13);
    expect_flow<float>(symmetry, 1e-5);
  }
}

}  // namespace
}  // namespace velum
