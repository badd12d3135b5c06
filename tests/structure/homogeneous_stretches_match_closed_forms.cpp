// problem:   a square sheet of triangles pulled in one direction, in both alike, and in one with
//            its width held; neo-Hookean and Mooney-Rivlin of two and five parameters
// reference: nominal stress of an incompressible solid, W1 and W2 its derivatives by I1 and I2:
//            uniaxial 2 (l - l^-2)(W1 + W2/l), equibiaxial 2 (l - l^-5)(W1 + l^2 W2), pure shear
//            2 (l - l^-3)(W1 + W2); Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5
// measure:   force on the pulled edge over undeformed thickness and width; sideways force where
//            there must be none
// tolerance: 1e-12 of the stress
// why:       a homogeneous state is exact in linear triangles: what remains is round-off
#include <gtest/gtest.h>

#include <cmath>

#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"

namespace velum::structure {
namespace {

constexpr double thickness = 0.02;
constexpr MooneyRivlin rubbers[] = {
    {.c10 = 0.5}, {.c10 = 0.4, .c01 = 0.1}, {0.4, 0.1, 0.05, -0.02, 0.01}};

/// Nominal stresses along y and z of the unit square stretched by l and m.
Eigen::Vector2d stresses(MooneyRivlin const& rubber, double l, double m)
{
  Sheet const s = make_sheet(strip_mesh(graded(0, 1, 4), graded(0, 1, 3)), thickness, rubber, 1);
  Eigen::VectorXd x = s.reference, force = Eigen::VectorXd::Zero(x.size());
  for (int a = 0; a < node_count(s); ++a) x[3 * a + 1] *= l, x[3 * a + 2] *= m;
  add_elastic_force(s, x, force);
  Eigen::Vector2d sum(0, 0);
  for (int a = 0; a < node_count(s); ++a)
    for (int axis : {1, 2})
      if (s.reference[3 * a + axis] == 1) sum[axis - 1] -= force[3 * a + axis];
  return sum / thickness;
}

InvariantEnergy slopes(MooneyRivlin const& rubber, double l, double m)
{
  double const a = l * l, b = m * m, c = 1 / (a * b);
  return invariant_energy(rubber, a + b + c - 3, a * b + (a + b) * c - 3);
}

TEST(HomogeneousStretch, is_exact_when_uniaxial)
{
  for (auto const& rubber : rubbers)
    for (double l : {0.7, 1.0, 1.05, 1.6, 3.0}) {
      double const across = 1 / std::sqrt(l);
      auto const w = slopes(rubber, l, across);
      auto const t = stresses(rubber, l, across);
      EXPECT_NEAR(t[0], 2 * (l - 1 / (l * l)) * (w.W1 + w.W2 / l), 1e-12) << l;
      EXPECT_NEAR(t[1], 0, 1e-12) << l;
    }
}

TEST(HomogeneousStretch, is_exact_when_equibiaxial)
{
  for (auto const& rubber : rubbers)
    for (double l : {0.8, 1.0, 1.3, 2.5}) {
      auto const w = slopes(rubber, l, l);
      auto const t = stresses(rubber, l, l);
      double const exact = 2 * (l - std::pow(l, -5)) * (w.W1 + l * l * w.W2);
      EXPECT_NEAR(t[0], exact, 1e-12 * (1 + std::abs(exact))) << l;
      EXPECT_NEAR(t[1], exact, 1e-12 * (1 + std::abs(exact))) << l;
    }
}

TEST(HomogeneousStretch, is_exact_in_pure_shear)
{
  for (auto const& rubber : rubbers)
    for (double l : {0.8, 1.0, 1.4, 3.0}) {
      auto const w = slopes(rubber, l, 1);
      double const exact = 2 * (l - std::pow(l, -3)) * (w.W1 + w.W2);
      EXPECT_NEAR(stresses(rubber, l, 1)[0], exact, 1e-12 * (1 + std::abs(exact))) << l;
    }
}

}  // namespace
}  // namespace velum::structure
