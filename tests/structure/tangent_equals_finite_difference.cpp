// problem:    derivative of elastic force, follower pressure, spring and lift stop by all node
//             positions
// reference:  central differences of the same force with step 1e-6 of the radius
// measure:    largest entry of the difference over the largest entry of the tangent
// tolerance:  1e-7
// why:        the differences err by step^2 (1e-12) and round-off over step (1e-16 / 1e-6 times a
//             few); a missing term would show as 1e-2 or more
#include "structure/internal_force.hpp"
#include "structure/lift_stop.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/spring.hpp"
#include "tests/support/derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::structure {
namespace {

/// An uneven, curved, stretched membrane: nothing vanishes by symmetry.
Membrane bent(core::Symmetry symmetry)
{
  auto m = flat_membrane({symmetry, 0, 1, 0.1, [](double y) { return 0.1 + 0.05 * y; },
                          MooneyRivlin{1, 0.5, 0.2, -0.1, 0.05}, 1});
  for (int i = 0; i < node_count(m); ++i) {
    double const y = m.reference[2 * i + 1];
    m.position[2 * i] = 0.4 * (1 - y * y) + 0.02 * std::sin(9 * y);
    m.position[2 * i + 1] = 1.1 * y + 0.02 * std::sin(7 * y);
  }
  return m;
}

double tangent_error(Load const& load, Eigen::VectorXd const& x)
{
  return tests::tangent_error(load, x, 1e-6, tests::all_of(x));
}

TEST(Tangent, equals_finite_difference_for_every_force)
{
  for (auto const symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
    auto const m = bent(symmetry);
    EXPECT_LT(tangent_error(tests::elasticity(m), m.position), 1e-7);

    auto pressure = uniform_pressure(m, Side::minus, 2);
    pressure.push_back({3, Side::plus, 0.2, 0.7, 5, -1});
    EXPECT_LT(tangent_error(pressure_load(m, pressure), m.position), 1e-7);

    EXPECT_LT(tangent_error(spring_load(m, {2, 3, 1, 0.47}), m.position), 1e-7);
    EXPECT_LT(tangent_error(stop_load(m, {0.2, 0.7, std::make_shared<double>(3)}), m.position), 1e-7);
  }
}

TEST(Tangent, equals_finite_difference_for_loads_of_a_sheet)
{
  Sheet s = make_sheet(disc_mesh(graded(0, 1, 3)), 0.1, neo_hookean_rubber(1), 1);
  for (int i = 0; i < s.position.size(); ++i) s.position[i] += 0.05 * std::sin(17.0 * i);
  EXPECT_LT(tangent_error(spring_load(s, {2, 3, 1, 0.47}), s.position), 1e-7);

  CornerPressure pressure(3, element_count(s));
  for (int i = 0; i < pressure.size(); ++i) pressure(i) = std::cos(5.0 * i);
  EXPECT_LT(tangent_error(pressure_load(s, pressure), s.position), 1e-7);
}

TEST(ElasticForce, is_minus_the_gradient_of_the_energy)
{
  for (auto const symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
    auto const m = bent(symmetry);
    auto const energy = [&](auto const& x) { return elastic_energy(m, x); };
    auto const force = tests::force_of(tests::elasticity(m), m.position);
    EXPECT_LT(tests::gradient_error(energy, force, m.position, 1e-6, tests::all_of(m.position)),
              1e-7);
  }
}

}  // namespace
}  // namespace velum::structure
