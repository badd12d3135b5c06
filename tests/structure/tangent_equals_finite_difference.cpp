// problem:    derivative of elastic force, follower pressure and spring by all node positions
// reference:  central differences of the same force with step 1e-6 of the radius
// measure:    largest entry of the difference over the largest entry of the tangent
// tolerance:  1e-7
// why:        the differences err by step^2 (1e-12) and round-off over step (1e-16 / 1e-6 times a
//             few); a missing term would show as 1e-2 or more
#include "structure/internal_force.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/spring.hpp"

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
  auto const n = x.size();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
  Triplets entries;
  load(x, force, &entries);
  Eigen::SparseMatrix<double> sparse(n, n);
  sparse.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixXd const tangent = sparse;
  Eigen::MatrixXd difference(n, n);
  double const step = 1e-6;
  for (int j = 0; j < n; ++j) {
    Eigen::VectorXd plus = Eigen::VectorXd::Zero(n), minus = plus, y = x;
    y[j] = x[j] + step, load(y, plus, nullptr);
    y[j] = x[j] - step, load(y, minus, nullptr);
    difference.col(j) = (plus - minus) / (2 * step);
  }
  return (tangent - difference).cwiseAbs().maxCoeff() / tangent.cwiseAbs().maxCoeff();
}

Load elasticity(Membrane const& m)
{
  return [&m](Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent) {
    add_elastic_force(m, x, force);
    if (!tangent) return;
    Triplets stiffness;
    add_stiffness(m, x, stiffness);
    for (auto const& t : stiffness) tangent->emplace_back(t.row(), t.col(), -t.value());
  };
}

TEST(Tangent, equals_finite_difference_for_every_force)
{
  for (auto const symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
    auto const m = bent(symmetry);
    EXPECT_LT(tangent_error(elasticity(m), m.position), 1e-7);

    auto pressure = uniform_pressure(m, Side::minus, 2);
    pressure.push_back({3, Side::plus, 0.2, 0.7, 5, -1});
    EXPECT_LT(tangent_error(pressure_load(m, pressure), m.position), 1e-7);

    EXPECT_LT(tangent_error(spring_load(m, {2, 3, 1, 0.47}), m.position), 1e-7);
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
    Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
    add_elastic_force(m, m.position, force);
    for (int j = 0; j < force.size(); ++j) {
      double const step = 1e-6;
      Eigen::VectorXd plus = m.position, minus = m.position;
      plus[j] += step, minus[j] -= step;
      double const slope = (elastic_energy(m, plus) - elastic_energy(m, minus)) / (2 * step);
      EXPECT_NEAR(force[j], -slope, 1e-7 * force.cwiseAbs().maxCoeff());
    }
  }
}

}  // namespace
}  // namespace velum::structure
