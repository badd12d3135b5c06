// problem:   a free membrane, clamped at its rim, in a closed box of low viscosity (tau - 1/2 =
//            0.009 and 0.0009) gets a small uneven kick; rho_s h/(rho_f dx) from 400 to 0.1; faces
//            half-way between cells and off that place; explicit (staggered) and implicit coupling
// reference: no energy comes in: the motion must die down. The staggered bounce-back has the local
//            limit rho_s h/(rho_f dx) of 34 to 62 for central moments and a half-way plate (a model
//            of two columns of cells)
// measure:   speed of the membrane over that of the kick; 1000 counts as blow-up
// tolerance: implicit: below the kick at every mass ratio. Explicit: blow-up at 10 and below where
//            the faces lie half-way, at 1 and below wherever; limit within a factor 2 of the
//            model's
// why:       growth is exponential, so the verdict does not depend on the count; interpolation off
//            the half-way place damps and moves the limit, but a moving face passes every place
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/check.hpp"
#include "structure/mass.hpp"
#include "structure/stable_step.hpp"
#include "tests/support/piston.hpp"

namespace velum {
namespace {

using ibm::Scheme;

struct Case {
  double place, thickness, viscosity;
};

/// Final speed over that of the kick, or 1000 as soon as it is reached.
double growth(Scheme scheme, Case const& c, double mass_ratio)
{
  double const kick = 1e-6, blow_up = 1000;
  int const steps = 5000;
  tests::PistonSpec spec{.nx = 24, .ny = 12, .place = c.place, .thickness = c.thickness};
  spec.open = false;
  spec.model.viscosity = c.viscosity;
  spec.density = mass_ratio / c.thickness;
  spec.shear_modulus = 0.1 / c.thickness;
  auto s = tests::make_piston(spec);
  s.scheme = scheme;
  s.substeps = structure::substeps_for(
      1,
      structure::stable_step(s.membrane, structure::lumped_mass(s.membrane), s.membrane.position),
      0.5);
  for (int a = 1; a + 1 < structure::node_count(s.membrane); ++a)
    s.membrane.velocity[2 * a] = kick * (a % 2 == 1 ? 1.0 : 0.3);
  double speed = 0;
  try {
    for (int t = 0; t < steps; ++t) {
      ibm::step(s);
      speed = s.membrane.velocity.cwiseAbs().maxCoeff() / kick;
      if (!(speed < blow_up)) return blow_up;
    }
  } catch (core::Divergence const&) {
    return blow_up;
  }
  return speed;
}

bool blows_up(Scheme scheme, Case const& c, double mass_ratio)
{
  return growth(scheme, c, mass_ratio) >= 1000;
}

TEST(ImplicitCoupling, IsStableAtEveryMassRatio)
{
  for (double place : {12.0, 12.2})
    for (double thickness : {0.01, 2.0})
      for (double viscosity : {0.003, 0.0003})
        for (double mass_ratio : {10.0, 4.0, 1.0, 0.5, 0.1})
          EXPECT_LT(growth(Scheme::implicit, {place, thickness, viscosity}, mass_ratio), 1)
              << "at x = " << place << ", h " << thickness << ", nu " << viscosity
              << ", mass ratio " << mass_ratio;
}

TEST(ExplicitCoupling, IsUnstableAtTheMassRatiosOfAValve)
{
  for (double thickness : {0.01, 2.0}) {
    for (double mass_ratio : {10.0, 4.0, 1.0, 0.1})
      EXPECT_TRUE(blows_up(Scheme::explicit_, {12, thickness, 0.003}, mass_ratio)) << mass_ratio;
    for (double place : {12.2, 12.5})
      for (double mass_ratio : {1.0, 0.1})
        EXPECT_TRUE(blows_up(Scheme::explicit_, {place, thickness, 0.003}, mass_ratio))
            << place << " " << mass_ratio;
  }
}

/// Largest mass ratio at which the explicit coupling blows up, to 5 %.
double limit(Case const& c)
{
  double lo = 1, hi = 200;
  EXPECT_TRUE(blows_up(Scheme::explicit_, c, lo));
  EXPECT_FALSE(blows_up(Scheme::explicit_, c, hi));
  while (hi / lo > 1.05) {
    double const middle = std::sqrt(lo * hi);
    (blows_up(Scheme::explicit_, c, middle) ? lo : hi) = middle;
  }
  return std::sqrt(lo * hi);
}

TEST(ExplicitCoupling, StopsBeingStableAtAMassRatioOfSomeTens)
{
  for (double viscosity : {0.003, 0.0003})
    for (double place : {12.0, 12.2}) {
      double const m = limit({place, 0.01, viscosity});
      std::printf(
          "explicit coupling, tau - 1/2 = %g, face %s: unstable below rho_s h/(rho_f dx) "
          "= %.2g\n",
          3 * viscosity, place == 12.0 ? "half-way" : "0.2 of a cell off it", m);
      if (place != 12.0) continue;
      EXPECT_GT(m, 34 / 2.0);
      EXPECT_LT(m, 62 * 2.0);
    }
}

}  // namespace
}  // namespace velum
