// problem:   an uneven sheet of triangles under homogeneous deformations; rigid motions; random
//            states
// reference: W of the strain alone; inner nodes without force; energy and forces turn with the
//            sheet; derivatives by central differences
// measure:   residual of inner nodes over the largest nodal force; differences over the largest
//            entry
// tolerance: 1e-13 for identities, 1e-7 for differences (step 1e-6 of the size: truncation 1e-12
//            over round-off 1e-10)
// why:       linear triangles hold every homogeneous deformation exactly: only round-off remains
#include <gtest/gtest.h>

#include <random>

#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/triangle_element.hpp"
#include "tests/support/derivatives.hpp"

namespace velum::structure {
namespace {

constexpr MooneyRivlin rubber{.c10 = 0.4, .c01 = 0.05, .c20 = 0.03, .c11 = -0.01, .c02 = 0.007};

/// A strip whose inner points are moved about.
Sheet uneven_sheet()
{
  auto mesh = strip_mesh(graded(0, 1, 5, 2), graded(0, 1.3, 6, 0.5));
  std::mt19937 engine{2};
  std::uniform_real_distribution<double> shift(-0.04, 0.04);
  auto const rim = rim_points(mesh);
  for (int a = 0; a < mesh.points.size() / 3; ++a)
    if (!std::ranges::binary_search(rim, a)) {
      mesh.points[3 * a + 1] += shift(engine);
      mesh.points[3 * a + 2] += shift(engine);
    }
  return make_sheet(mesh, 0.01, rubber, 1);
}

Eigen::VectorXd moved(Sheet const& s, Eigen::Matrix3d const& F)
{
  Eigen::VectorXd x = s.reference;
  for (int a = 0; a < node_count(s); ++a) x.segment<3>(3 * a) = F * node3(s.reference, a);
  return x;
}

Eigen::Matrix3d stretched(double y, double z, double shear)
{
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(1, 1) = y, F(2, 2) = z, F(1, 2) = shear, F(0, 1) = 0.3;
  return F;
}

Eigen::VectorXd elastic_force(Sheet const& s, Eigen::VectorXd const& x)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
  add_elastic_force(s, x, force);
  return force;
}

/// A state without any symmetry.
Eigen::VectorXd crumpled(Sheet const& s)
{
  std::mt19937 engine{5};
  std::normal_distribution<double> shift(0, 0.02);
  Eigen::VectorXd x = moved(s, stretched(1.3, 0.9, 0.2));
  for (double& c : x) c += shift(engine);
  return x;
}

TEST(Triangles, pass_the_patch_test)
{
  Sheet const s = uneven_sheet();
  auto const rim = rim_points({s.reference, s.triangles});
  for (auto const& F : {stretched(1.4, 1.1, 0), stretched(0.9, 1.7, 0.4), stretched(2, 2, -0.3)}) {
    Eigen::VectorXd const x = moved(s, F), force = elastic_force(s, x);
    Eigen::Matrix3d const C = F.transpose() * F;
    double const W = plane_stress(rubber, C(1, 1), C(2, 2), C(1, 2)).W;
    EXPECT_NEAR(elastic_energy(s, x) / (W * 0.01 * 1.3), 1, 1e-13);
    for (int a = 0; a < node_count(s); ++a)
      EXPECT_TRUE(std::ranges::binary_search(rim, a) ||
                  node3(force, a).norm() < 1e-13 * force.cwiseAbs().maxCoeff())
          << a;
  }
}

TEST(Triangles, have_a_consistent_mass_whose_rows_sum_up_to_the_lumped)
{
  Sheet const s = uneven_sheet();
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(3 * node_count(s));
  for (auto const& entry : consistent_mass(s)) rows[entry.row()] += entry.value();
  Eigen::VectorXd const lumped = lumped_mass(s);
  for (int i = 0; i < rows.size(); ++i) EXPECT_NEAR(rows[i] / lumped[i / 3], 1, 1e-13) << i;
}

TEST(Triangles, feel_no_rigid_motion)
{
  Sheet const s = uneven_sheet();
  Eigen::Matrix3d const R =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  EXPECT_LT(elastic_force(s, moved(s, R)).cwiseAbs().maxCoeff(), 1e-15);
  Eigen::VectorXd const x = crumpled(s), force = elastic_force(s, x);
  Eigen::VectorXd turned = x;
  for (int a = 0; a < node_count(s); ++a)
    turned.segment<3>(3 * a) = R * node3(x, a) + Eigen::Vector3d(3, 1, -2);
  Eigen::VectorXd const after = elastic_force(s, turned);
  EXPECT_NEAR(elastic_energy(s, turned) / elastic_energy(s, x), 1, 1e-12);
  for (int a = 0; a < node_count(s); ++a)
    EXPECT_LT((node3(after, a) - R * node3(force, a)).norm(), 1e-13);
}

/// Every seventh: as many of x as of y and z.
tests::Components some(Eigen::VectorXd const& x)
{
  tests::Components chosen;
  for (int i = 0; i < x.size(); i += 7) chosen.push_back(i);
  return chosen;
}

TEST(Triangles, have_the_force_and_tangent_of_their_energy)
{
  Sheet const s = uneven_sheet();
  Eigen::VectorXd const x = crumpled(s);
  auto const elasticity = tests::elasticity(s);
  auto const energy = [&](auto const& at) { return elastic_energy(s, at); };
  EXPECT_LT(tests::gradient_error(energy, elastic_force(s, x), x, 1e-6, some(x)), 1e-7);
  EXPECT_LT(tests::tangent_error(elasticity, x, 1e-6, some(x)), 1e-7);
  Eigen::MatrixXd const K = tests::tangent_of(elasticity, x);
  EXPECT_LT((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-14 * K.cwiseAbs().maxCoeff());
}

TEST(Triangles, have_the_pressure_of_their_volume_and_its_tangent)
{
  Sheet const s = uneven_sheet();
  Eigen::VectorXd const x = crumpled(s);
  Eigen::VectorXd const p = Eigen::VectorXd::LinSpaced(element_count(s), 0.5, 2);
  EXPECT_LT(tests::tangent_error(pressure_load(s, p), x, 1e-6, some(x)), 1e-7);
  // of one pressure, at points off the rim
  Eigen::VectorXd const one = Eigen::VectorXd::Constant(element_count(s), -1);
  auto const rim = rim_points({s.reference, s.triangles});
  tests::Components inner;
  for (int i = 0; i < x.size(); ++i)
    if (!std::ranges::binary_search(rim, i / 3)) inner.push_back(i);
  auto const volume = [&](auto const& at) { return -swept_volume(s, at); };
  EXPECT_LT(
      tests::gradient_error(volume, tests::force_of(pressure_load(s, one), x), x, 1e-6, inner),
      1e-7);
}

}  // namespace
}  // namespace velum::structure
