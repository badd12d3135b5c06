// problem:   impulsive pressure start through a plane slit of N cells under a plate 5N thick at a
//            valve's viscosity: Bernoulli velocity U = 0.1, U N/nu = 2500, so that tau - 1/2 =
//            2.4e-4 (N = 2) and 4.8e-4 (N = 4)
// reference: an earlier program at these numbers: BGK and TRT blow up; central moments, whose trace
//            relaxes at its own rate 1, give discharge coefficients of 0.73 and 0.78 in a wide tank
// measure:   whether the flow stays finite and below the lattice speed; discharge over the second
//            half of the run, q/(N U)
// tolerance: blow-up of BGK and TRT; central moments bounded, discharge between 0.4 and 0.9
// why:       start-up sound and wall corners feed modes that only the trace's own rate damps. Here
//            the slow mean of the outflow still holds back part of the pressure (0.49 and 0.54
//            seen), so the discharge is a check of sense, not of accuracy
#include <gtest/gtest.h>

#include <cmath>

#include "lbm/observe.hpp"
#include "tests/support/flow.hpp"

namespace velum {
namespace {

/// Steps until the flow is not finite or faster than the lattice, and the discharge coefficient.
struct Outcome {
  int survived;
  double discharge;
};

Outcome slit(lbm::Collision collision, double magic, int N, int steps)
{
  double const U = 0.1;
  lbm::Model model{collision, U * N / 2500, magic};
  int const up = 10 * N, plate = 5 * N, nx = up + plate + 20 * N, ny = 8 * N;
  auto flow = tests::make_flow(
      lbm::make_fluid<double>(nx, ny, {0, 0}, core::Symmetry::planar, model),
      core::box({double(up), double(N)}, {double(up + plate), 100.0 * N}),
      [&](lbm::WallHit const& h) {
        return h.i == 0 && lbm::D2Q9::cx(h.dir) < 0        ? 0
               : h.i == nx - 1 && lbm::D2Q9::cx(h.dir) > 0 ? 1
                                                           : -1;
      },
      {{lbm::OpeningKind::pressure, {1, 0}, U * U / 2}, {lbm::OpeningKind::outflow, {-1, 0}, 0.0}});
  double volume = 0;
  for (int t = 0; t < steps; ++t) {
    tests::step(flow);
    if (2 * t >= steps) volume -= flow.openings[1].mass_flow;
    if (t % 20 != 0) continue;
    auto const seen = lbm::observe(flow.fluid);
    if (seen.not_finite > 0 || seen.speed_max > 1) return {t, 0};
  }
  return {steps, volume / (steps / 2) / (N * U)};
}

TEST(LowViscosity, BlowsUpWithBgkAndTrt)
{
  for (int N : {2, 4}) {
    int const steps = 4000;
    EXPECT_LT(slit(lbm::Collision::bgk, 0, N, steps).survived, steps) << N;
    for (double magic : {1.0 / 8, 1.0 / 4})
      EXPECT_LT(slit(lbm::Collision::trt, magic, N, steps).survived, steps) << N << " " << magic;
  }
}

TEST(LowViscosity, IsBoundedWithCentralMoments)
{
  for (int N : {2, 4}) {
    int const steps = 6000;
    Outcome const o = slit(lbm::Collision::central_moments, 1.0 / 8, N, steps);
    EXPECT_EQ(o.survived, steps) << N;
    EXPECT_GT(o.discharge, 0.4) << N;
    EXPECT_LT(o.discharge, 0.9) << N;
  }
}

}  // namespace
}  // namespace velum
