// problem:   the incompressibility dilemma: a box without openings, parted by a membrane that moves
//            in by 2 and 10 % of a chamber (prescribed) or under an outer load (free, clamped at
//            its rim, rho_s h/(rho_f dx) from 10 to 0.1); planar and axisymmetric, thick and thin
// reference: each chamber keeps its mass: rho = V0/V, p = c_s^2 (V0/V - 1), V0 and V by the faces
// measure:   pressure rise once at rest over the reference, both chambers; its largest excess on
//            the way; how uniform the pressure is at the end
// tolerance: 1 %; excess on the way 2 %; uniform to 1e-3 of the rise
// why:       interpolated bounce-back and the refill of uncovered cells keep mass to second order
//            only, and a thick face that tilts at its clamp sweeps a little more than its nodes do
//            (0.1 to 0.5 % seen); an unstable coupling would show as excess and as noise
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "structure/mass.hpp"
#include "structure/stable_step.hpp"
#include "tests/support/chambers.hpp"

namespace velum {
namespace {

using core::Symmetry;

struct Case {
  Symmetry symmetry;
  double thickness;
};

std::vector<Case> const cases = {{Symmetry::planar, 2},
                                 {Symmetry::planar, 0.01},
                                 {Symmetry::axisymmetric, 2},
                                 {Symmetry::axisymmetric, 0.01}};

std::string name(Case const& c)
{
  return (c.symmetry == Symmetry::planar ? "planar, h " : "axisymmetric, h ") +
         std::to_string(c.thickness);
}

tests::PistonSpec closed_box(Case const& c)
{
  tests::PistonSpec spec{
      .nx = 40, .ny = 20, .symmetry = c.symmetry, .place = 20.3, .thickness = c.thickness};
  spec.open = false;
  spec.model.viscosity = 0.05;
  return spec;
}

void expect_lattice_compressibility(tests::Chambers const& before, tests::Chambers const& after,
                                    std::string const& what)
{
  for (int k : {0, 1}) {
    tests::Chamber const &a = before.side[k], &b = after.side[k];
    double const rise = a.volume / b.volume - 1;
    EXPECT_GT(std::abs(rise), 0.015) << what << ": the chamber was hardly touched";
    EXPECT_NEAR(b.density / rise, 1, 0.01) << what << (k == 0 ? ", plus side" : ", minus side");
    EXPECT_LT(b.highest - b.lowest, 1e-3 * std::abs(rise)) << what << ": still ringing";
  }
}

/// A shape that is level at the rim, as a clamp holds it, and has the mean 1 over the section.
double bulge(Symmetry symmetry, double y, double R)
{
  double const z = symmetry == Symmetry::planar ? 2 * y / R - 1 : y / R;
  return (symmetry == Symmetry::planar ? 15.0 / 8 : 3.0) * (1 - z * z) * (1 - z * z);
}

TEST(ClosedChamber, AnswersAPrescribedMotion)
{
  int const ramp = 2000, rest = 2000;
  double const pi = std::acos(-1.0);
  for (Case const& c : cases)
    for (double share : {0.02, 0.1}) {
      auto s = tests::make_piston(closed_box(c));
      auto const before = tests::chambers(s);
      for (int t = 0; t < ramp; ++t) {
        double const speed = share * 20 / ramp * (1 - std::cos(2 * pi * (t + 0.5) / ramp));
        tests::drive(s, [&](double y) { return speed * bulge(c.symmetry, y, 20); });
        ibm::step(s);
      }
      tests::drive(s, [](double) { return 0.0; });
      for (int t = 0; t < rest; ++t) ibm::step(s);
      expect_lattice_compressibility(before, tests::chambers(s),
                                     name(c) + " share " + std::to_string(share));
    }
}

/// Presses a free membrane with a dead load per area, ramped, and waits until all is at rest.
void press(Case const& c, double mass_ratio)
{
  auto spec = closed_box(c);
  spec.density = mass_ratio / c.thickness;
  spec.shear_modulus = 0.3 / c.thickness;
  spec.damping.alpha = 0.02;
  auto s = tests::make_piston(spec);
  auto const before = tests::chambers(s);
  Eigen::VectorXd const mass = structure::lumped_mass(s.membrane);
  double load = 0;
  s.loads.push_back([&](Eigen::VectorXd const&, Eigen::VectorXd& force, structure::Triplets*) {
    for (int a = 0; a < structure::node_count(s.membrane); ++a)
      force[2 * a] += load * mass[a] / mass_ratio;
  });
  s.substeps = structure::substeps_for(
      1, structure::stable_step(s.membrane, mass, s.membrane.position), 0.5);
  int const ramp = 2000, rest = 2500;
  double peak = 0;
  for (int t = 0; t < ramp + rest; ++t) {
    double const z = std::min(1.0, double(t) / ramp);
    load = 0.02 * z * z * (3 - 2 * z);
    ibm::step(s);
    if (t % 50 == 0) peak = std::max(peak, tests::chambers(s).side[0].density);
  }
  auto const after = tests::chambers(s);
  std::string const what = name(c) + " mass ratio " + std::to_string(mass_ratio);
  expect_lattice_compressibility(before, after, what);
  EXPECT_LT(peak, 1.02 * after.side[0].density) << what;
}

TEST(ClosedChamber, AnswersAFreeMembraneAtEveryMassRatio)
{
  for (Case const& c : cases)
    for (double mass_ratio : {10.0, 4.0, 1.0, 0.5, 0.1})
      if (c.thickness > 1 || mass_ratio == 10 || mass_ratio == 0.1) press(c, mass_ratio);
}

}  // namespace
}  // namespace velum
