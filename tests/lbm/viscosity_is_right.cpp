// problem:   decaying shear wave u = u0 sin(2 pi y/n), n = 64, in a periodic strip, for each
//            collision in double and single precision, nu from 1e-3 to 0.5
// reference: amplitude ~ exp(-nu k^2 t)
// measure:   viscosity from the decay of the amplitude between two times, relative error
// tolerance: 1 %
// why:       the scheme's own error is of order k^2 = 0.01 times a coefficient of the relaxation
//            times (up to 0.75 at nu = 0.5); a wrong rate is wrong by its full size
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"

namespace velum {
namespace {

template <class Real>
double measured_viscosity(lbm::Collision collision, double nu)
{
  int const n = 64;
  double const k = 2 * std::acos(-1.0) / n, u0 = 0.05;
  lbm::Model model{collision, nu, 1.0 / 8};
  model.periodic_x = model.periodic_y = true;
  auto fluid = lbm::make_fluid<Real>(3, n, {0, 0}, core::Symmetry::planar, model);
  lbm::CellStates state("state", n, 3);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 3; ++i) state(j, i) = {0, u0 * std::sin(k * (j + 0.5)), 0};
  lbm::set_equilibrium(fluid, state);
  auto const amplitude = [&] {
    auto const now = lbm::cell_states(fluid);
    double sum = 0;
    for (int j = 0; j < n; ++j) sum += now(j, 1).ux * std::sin(k * (j + 0.5));
    return sum;
  };
  auto const march = [&](int steps) {
    for (int t = 0; t < steps; ++t) {
      lbm::fill_ghosts(fluid);
      lbm::stream_and_collide(fluid);
    }
  };
  march(100);  // the stress of the start, which the equilibrium lacks, forms
  double const before = amplitude();
  int const steps = int(0.3 / (nu * k * k));
  march(steps);
  return std::log(before / amplitude()) / (k * k * steps);
}

TEST(Viscosity, IsRightWithEachCollision)
{
  for (auto c : {lbm::Collision::bgk, lbm::Collision::trt, lbm::Collision::recursive_regularised,
                 lbm::Collision::central_moments})
    for (double nu : {1e-3, 0.03, 1.0 / 6, 0.5}) {
      EXPECT_NEAR(measured_viscosity<double>(c, nu) / nu, 1, 0.01) << int(c) << " nu " << nu;
      EXPECT_NEAR(measured_viscosity<float>(c, nu) / nu, 1, 0.01)
          << int(c) << " nu " << nu << ", single precision";
    }
}

}  // namespace
}  // namespace velum
