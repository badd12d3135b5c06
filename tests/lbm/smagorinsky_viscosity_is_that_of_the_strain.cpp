// problem:   Smagorinsky's model without strain; in plane shear between a wall and a lid, n = 12,
//            at small, middling and large molecular viscosity; switched off
// reference: nu_t = (C dx)^2 |S|, |S| = |du/dy| of the computed profile, whose shear stress is rho
//            (nu + nu_t) du/dy (Smagorinsky, Mon. Weather Rev. 91 (1963) 99)
// measure:   reported mean and largest eddy viscosity; momentum that crosses a plane per step
// tolerance: 1 %; no strain: 1e-12 of the molecular viscosity; off: bitwise
// why:       the local non-equilibrium gives |S| up to terms of the second order in the velocity,
//            which the wall rows have most of with TRT (hence a slow lid, and a constant out of all
//            custom to give the eddies a share); the profile is linear, so nothing else is in error
#include <gtest/gtest.h>

#include <cmath>

#include "lbm/eddy_share.hpp"
#include "lbm/observe.hpp"
#include "lbm/smagorinsky.hpp"
#include "tests/support/flow.hpp"

namespace velum {
namespace {

struct Shear {
  double rate;  // |du/dy| in the middle
  lbm::EddyViscosity reported;
  double stress;  // momentum flux through the middle
};

Shear shear(lbm::Collision collision, double nu, double constant)
{
  int const n = 12;
  double const lid = 0.005;
  lbm::Model model{collision, nu, 1.0 / 8, constant};
  model.periodic_x = true;
  auto flow = tests::make_flow(lbm::make_fluid<double>(4, n, {0, 0}, core::Symmetry::planar, model),
                               tests::no_solids(),
                               [&](lbm::WallHit const& h) { return h.at[1] > n / 2.0 ? -2 : -1; });
  flow.wall_velocity = {lid, 0};
  lbm::CellStates state("state", n, 4);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 4; ++i) state(j, i) = {0, lid * (j + 0.5) / n, 0};
  lbm::set_equilibrium(flow.fluid, state);
  for (int t = 0; t < 20000; ++t) tests::step(flow);

  auto const now = lbm::cell_states(flow.fluid);
  double flux = 0;  // between rows n/2 - 1 and n/2, downwards
  for (int d = 1; d < 9; ++d) {
    int const cy = lbm::D2Q9::cy(d);
    int const cell = flow.fluid.cell(1, cy > 0 ? n / 2 - 1 : n / 2);
    if (cy != 0) flux -= lbm::D2Q9::cx(d) * cy * flow.fluid.f.outgoing(d, cell);
  }
  return {now(n / 2, 1).ux - now(n / 2 - 1, 1).ux, lbm::eddy_viscosity(flow.fluid), flux};
}

TEST(Smagorinsky, GivesItsViscosityInPlaneShear)
{
  for (auto c : {lbm::Collision::bgk, lbm::Collision::trt, lbm::Collision::central_moments})
    for (double nu : {0.002, 1.0 / 6, 0.3})
      for (double constant : {0.1, 4.0}) {
        Shear const s = shear(c, nu, constant);
        double const nu_t = constant * constant * s.rate;
        EXPECT_NEAR(s.reported.mean / nu_t, 1, 0.01) << int(c) << " " << nu << " " << constant;
        EXPECT_NEAR(s.reported.max / nu_t, 1, 0.01) << int(c) << " " << nu << " " << constant;
        EXPECT_NEAR(s.stress / ((nu + nu_t) * s.rate), 1, 0.01)
            << int(c) << " " << nu << " " << constant;
      }
}

TEST(Smagorinsky, LeavesTheMolecularViscosityWithoutStrain)
{
  for (double nu : {1e-4, 0.1, 1.0}) {
    double const tau = lbm::smagorinsky_time(3 * nu + 0.5, 0.0, 1 / 1.02, 0.01);
    EXPECT_NEAR((tau - 0.5) / 3 / nu, 1, 1e-12);
  }
}

// Every cell of a channel four cells wide is next to a wall or next to such a cell.
TEST(Smagorinsky, SparesTheFlowThroughAGap)
{
  auto const flow_rate = [](double constant, bool spared) {
    lbm::Model model{lbm::Collision::central_moments, 0.005, 1.0 / 8, constant};
    model.periodic_x = true;
    model.body_force = {4e-5, 0};
    auto flow =
        tests::make_flow(lbm::make_fluid<double>(4, 4, {0, 0}, core::Symmetry::planar, model),
                         tests::no_solids(), [](lbm::WallHit const&) { return -1; });
    if (spared) lbm::spare_walls(flow.fluid, flow.walls.hits);
    for (int t = 0; t < 20000; ++t) tests::step(flow);
    auto const now = lbm::cell_states(flow.fluid);
    double sum = 0;
    for (int j = 0; j < 4; ++j) sum += now(j, 1).ux;
    return sum;
  };
  double const laminar = flow_rate(0, false);
  EXPECT_NEAR(flow_rate(0.3, true) / laminar, 1, 1e-10);
  EXPECT_LT(flow_rate(0.3, false) / laminar, 0.95);
}

TEST(Smagorinsky, IsNotThereWhenOff)
{
  Shear const off = shear(lbm::Collision::central_moments, 0.01, 0);
  EXPECT_EQ(off.reported.mean, 0);
  EXPECT_EQ(off.reported.max, 0);
  // a constant whose square is zero takes the path of no model, to the last bit
  Shear const zero = shear(lbm::Collision::central_moments, 0.01, 1e-200);
  EXPECT_EQ(off.rate, zero.rate);
  EXPECT_EQ(off.stress, zero.stress);
}

}  // namespace
}  // namespace velum
