// problem:   decaying Taylor-Green vortex in a periodic square of n cells, n = 16, 32, 64, at fixed
//            Reynolds number and diffusive scaling (velocity ~ 1/n), for each collision
// reference: u = -u0 cos kx sin ky exp(-2 nu k^2 t), v = u0 sin kx cos ky exp(-2 nu k^2 t)
//            (Taylor & Green, Proc. R. Soc. A 158 (1937) 499)
// measure:   L2 norm of the velocity error over that of the velocity after one decay time
// tolerance: order 2 +- 0.25 over three grids; error below 1 % at n = 64
// why:       the scheme and the compressibility error are both second order in this scaling
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"
#include "tests/support/order.hpp"

namespace velum {
namespace {

template <class Real>
double error(lbm::Collision collision, int n)
{
  double const pi = std::acos(-1.0), k = 2 * pi / n, u0 = 0.64 / n, nu = 0.02;
  lbm::Model model{collision, nu, 1.0 / 8};
  model.periodic_x = model.periodic_y = true;
  auto fluid = lbm::make_fluid<Real>(n, n, {0, 0}, core::Symmetry::planar, model);
  lbm::CellStates state("state", n, n);
  auto const exact = [&](int i, int j, double decay) {
    double const x = k * (i + 0.5), y = k * (j + 0.5), u = u0 * decay;
    return lbm::CellState{-0.75 * u * u * (std::cos(2 * x) + std::cos(2 * y)),
                          -u * std::cos(x) * std::sin(y), u * std::sin(x) * std::cos(y)};
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) state(j, i) = exact(i, j, 1);
  lbm::set_equilibrium(fluid, state);
  int const steps = int(1 / (2 * nu * k * k));
  for (int t = 0; t < steps; ++t) {
    lbm::fill_ghosts(fluid);
    lbm::stream_and_collide(fluid);
  }
  auto const now = lbm::cell_states(fluid);
  double const decay = std::exp(-2 * nu * k * k * steps);
  double e2 = 0, u2 = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      auto const s = exact(i, j, decay);
      e2 += std::pow(now(j, i).ux - s.ux, 2) + std::pow(now(j, i).uy - s.uy, 2);
      u2 += s.ux * s.ux + s.uy * s.uy;
    }
  return std::sqrt(e2 / u2);
}

TEST(TaylorGreen, IsSecondOrderWithEachCollision)
{
  for (auto c : {lbm::Collision::bgk, lbm::Collision::trt, lbm::Collision::recursive_regularised,
                 lbm::Collision::central_moments}) {
    std::vector<double> const h = {1. / 16, 1. / 32, 1. / 64};
    std::vector<double> const e = {error<double>(c, 16), error<double>(c, 32),
                                   error<double>(c, 64)};
    EXPECT_NEAR(tests::order(h, e), 2, 0.25)
        << int(c) << ": " << e[0] << " " << e[1] << " " << e[2];
    EXPECT_LT(e[2], 0.01);
  }
}

TEST(TaylorGreen, SinglePrecisionIsAsGood)
{
  auto const c = lbm::Collision::central_moments;
  EXPECT_NEAR(error<float>(c, 32), error<double>(c, 32), 1e-3 * error<double>(c, 32) + 2e-5);
}

}  // namespace
}  // namespace velum
