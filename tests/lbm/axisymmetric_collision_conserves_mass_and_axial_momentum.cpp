// problem:   one collision of random populations at radii from half a cell to 100, planar and
//            axisymmetric, each collision, with and without Smagorinsky's model; a closed round box
//            with a vortex ring in it
// reference: populations weighted by the ring of the mid-point of their link, y + c_y/2 going out
//            and y - c_y/2 coming in, keep mass and axial momentum (lbm/README.md); planar
//            collisions keep mass and momentum; fluid at rest stays
// measure:   change of the sums over one collision; of the box's mass over 3000 steps, over the
//            mass
// tolerance: 1e-14 of the largest term; rest exactly zero; box 1e-13 in double, 1e-6 in single
// why:       the identities are exact in the discrete scheme; what remains is round-off, which adds
//            up at random over the steps
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lbm/collide.hpp"
#include "lbm/observe.hpp"
#include "tests/support/flow.hpp"
#include "tests/support/rules.hpp"

namespace velum {
namespace {

using lbm::D2Q9;

struct Sums {
  double mass = 0, x = 0, y = 0;
};

/// Sums of populations, weighted by the radius at the mid-point of the link they go out or came by.
Sums sums(double const (&f)[9], double radius, double sign)
{
  Sums s;
  for (int i = 0; i < 9; ++i) {
    double const weight = radius > 0 ? radius + sign * D2Q9::cy(i) / 2.0 : 1.0;
    s.mass += weight * f[i];
    s.x += weight * D2Q9::cx(i) * f[i];
    s.y += weight * D2Q9::cy(i) * f[i];
  }
  return s;
}

struct Random {
  std::mt19937 engine{1};
  void fill(double (&f)[9])
  {
    std::uniform_real_distribution<double> noise(-0.1, 0.1);
    for (int i = 0; i < 9; ++i) f[i] = D2Q9::w(i) * noise(engine);
  }
};

TEST(AxisymmetricCollision, KeepsMassAndAxialMomentum)
{
  Random random;
  tests::with_each_rule<D2Q9>([&](auto const& rule) {
    for (double radius : {0.5, 1.5, 7.5, 100.5})
      for (double c2 : {0.0, 0.01})
        for (int n = 0; n < 20; ++n) {
          double f[9];
          random.fill(f);
          Sums const before = sums(f, radius, -1);
          lbm::collide<D2Q9, true, true>(f, rule, {{}, 1 / radius, c2});
          Sums const after = sums(f, radius, 1);
          EXPECT_NEAR(after.mass, before.mass, 1e-15 * radius) << "radius " << radius;
          EXPECT_NEAR(after.x, before.x, 1e-15 * radius) << "radius " << radius;
        }
  });
}

TEST(AxisymmetricCollision, LeavesRestAlone)
{
  tests::with_each_rule<D2Q9>([&](auto const& rule) {
    for (double radius : {0.5, 1.5, 100.5}) {
      double f[9] = {};
      lbm::collide<D2Q9, true, true>(f, rule, {{}, 1 / radius, 0.01});
      for (double v : f) EXPECT_EQ(v, 0);
      for (int i = 0; i < 9; ++i) f[i] = D2Q9::w(i) * 0.05;  // and rest at any pressure
      lbm::collide<D2Q9, true, true>(f, rule, {{}, 1 / radius, 0.01});
      for (int i = 0; i < 9; ++i) EXPECT_NEAR(f[i], D2Q9::w(i) * 0.05, 1e-16);
    }
  });
}

TEST(PlanarCollision, KeepsMassAndAddsTheForceToTheMomentum)
{
  Random random;
  tests::with_each_rule<D2Q9>([&](auto const& rule) {
    for (double force : {0.0, 1e-3})
      for (int n = 0; n < 20; ++n) {
        double f[9];
        random.fill(f);
        Sums const before = sums(f, 0, 0);
        lbm::collide<D2Q9, false, true>(f, rule, {{force, -2 * force}, 0, 0.01});
        Sums const after = sums(f, 0, 0);
        EXPECT_NEAR(after.mass, before.mass, 1e-15);
        EXPECT_NEAR(after.x, before.x + force, 1e-15);
        EXPECT_NEAR(after.y, before.y - 2 * force, 1e-15);
      }
  });
}

/// Mass of all populations less that at rest, over that at rest.
template <class Real>
double relative_mass(lbm::Fluid<Real> const& fluid)
{
  double mass = 0, rest = 0;
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i)
      for (int d = 0; d < 9; ++d) {
        double const ring = lbm::link_ring(fluid.symmetry, j + 0.5, d);
        mass += ring * double(fluid.f.outgoing(d, fluid.cell(i, j)));
        rest += ring * D2Q9::w(d);
      }
  return mass / rest;
}

template <class Real>
void expect_box_keeps_mass(double tolerance)
{
  int const nx = 24, ny = 16;
  double const pi = std::acos(-1.0);
  for (auto c : {lbm::Collision::bgk, lbm::Collision::trt, lbm::Collision::central_moments}) {
    auto flow = tests::make_flow(
        lbm::make_fluid<Real>(nx, ny, {0, 0}, core::Symmetry::axisymmetric, {c, 0.005, 1.0 / 8}),
        tests::no_solids(), [](lbm::WallHit const&) { return -1; });
    lbm::CellStates state("state", ny, nx);
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        double const x = pi * (i + 0.5) / nx, y = pi * (j + 0.5) / ny;
        state(j, i) = {0.01 * std::cos(x), 0.1 * std::sin(x) * std::cos(y),
                       -0.1 * std::cos(x) * std::sin(y)};
      }
    lbm::set_equilibrium(flow.fluid, state);
    double const before = relative_mass(flow.fluid);
    for (int t = 0; t < 3000; ++t) tests::step(flow);
    EXPECT_NEAR(relative_mass(flow.fluid), before, tolerance) << int(c);
    EXPECT_GT(lbm::observe(flow.fluid).speed_max, 1e-3) << int(c) << ": the flow must live on";
  }
}

TEST(AxisymmetricBox, KeepsItsMass)
{
  expect_box_keeps_mass<double>(1e-13);
  expect_box_keeps_mass<float>(1e-6);
}

}  // namespace
}  // namespace velum
