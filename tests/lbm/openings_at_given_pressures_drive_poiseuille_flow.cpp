// problem:   a channel of n = 8 cells and a pipe of 8 cells radius, 50 n long, between two pressure
//            openings
// reference: Q = dp n^3/(12 nu L) and pi dp n^4/(8 nu L)
// measure:   flow rate at both ends over the reference with the drop between the openings; and with
//            the drop between sections 5 n from the ends
// tolerance: 1 % planar, 2 % pipe
// why:       at an opening no shear stress acts, so the profile forms within some 0.1 n at each
//            end, 0.3 to 0.5 % of this length; nu and magic give odd and even rates the product
//            1/8, at which the walls of a channel cost no flux (1/n^2 = 1.6 % in a pipe)
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"

namespace velum {
namespace {

void expect_poiseuille(lbm::Collision collision, core::Symmetry symmetry)
{
  int const n = 8, nx = 50 * n, margin = 5 * n;
  double const nu = 1.0 / 12, drop = 1e-4;
  auto flow = tests::make_flow(
      lbm::make_fluid<double>(nx, n, {0, 0}, symmetry, {collision, nu, 1.0 / 8}),
      tests::no_solids(), tests::open_ends(nx),
      {{lbm::OpeningKind::pressure, {1, 0}, drop}, {lbm::OpeningKind::pressure, {-1, 0}, 0.0}});
  for (int t = 0; t < 8000; ++t) tests::step(flow);

  bool const round = symmetry == core::Symmetry::axisymmetric;
  double const per_gradient =
      round ? std::acos(-1.0) * std::pow(n, 4) / (8 * nu) : std::pow(n, 3) / (12 * nu);
  auto const state = lbm::cell_states(flow.fluid);
  auto const pressure = [&](int i) { return state(n / 2, i).rho / 3; };
  double const inner = (pressure(margin) - pressure(nx - margin)) / (nx - 2 * margin);
  double const tolerance = round ? 0.02 : 0.01;
  for (int k : {0, 1}) {
    double const Q = std::abs(flow.openings[static_cast<std::size_t>(k)].mass_flow);
    EXPECT_NEAR(Q / (per_gradient * drop / nx), 1, tolerance) << int(collision) << " " << round;
    EXPECT_NEAR(Q / (per_gradient * inner), 1, tolerance) << int(collision) << " " << round;
  }
}

TEST(PressureOpenings, DrivePoiseuilleFlow)
{
  for (auto symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
    expect_poiseuille(lbm::Collision::trt, symmetry);
    expect_poiseuille(lbm::Collision::central_moments, symmetry);
  }
}

}  // namespace
}  // namespace velum
