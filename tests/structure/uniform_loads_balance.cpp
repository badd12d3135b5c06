// problem:    forces that must vanish or sum up exactly, on a curved membrane with a thick edge
// reference:  rigid motion strains nothing; equal pressures on both sides cancel; the axial force
//             of a pressure is p times the projected area; the volume of rubber is constant
// measure:    largest nodal force over that of one element strained by 1; relative sums
// tolerance:  1e-12
// why:        exact identities of the discrete membrane; only round-off is left
#include "structure/faces.hpp"
#include "structure/internal_force.hpp"
#include "structure/line_element.hpp"
#include "structure/membrane.hpp"
#include "structure/pressure_load.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/spring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace velum::structure {
namespace {

Membrane cap(core::Symmetry symmetry)
{
  auto m = flat_membrane(
      {symmetry, 0, 2, 0.1, [](double y) { return 0.1 + 0.1 * y; }, neo_hookean_rubber(3), 1});
  for (int i = 0; i < node_count(m); ++i) {
    double const angle = 0.5 * m.reference[2 * i + 1];
    m.position[2 * i] = 2 * std::cos(angle);
    m.position[2 * i + 1] = 2.2 * std::sin(angle);
  }
  return m;
}

TEST(RigidTranslation, gives_no_force)
{
  auto m = cap(core::Symmetry::axisymmetric);
  m.position = m.reference;
  for (int i = 0; i < node_count(m); ++i) m.position[2 * i] += 0.37;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
  add_elastic_force(m, m.position, force);
  double const unit = element_tangent(m, m.reference, element_count(m) - 1).cwiseAbs().maxCoeff();
  EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-12 * unit);
}

TEST(Pressure, equal_on_both_sides_does_nothing)
{
  auto const m = cap(core::Symmetry::axisymmetric);
  auto pressure = uniform_pressure(m, Side::minus, 7);
  Eigen::VectorXd one = Eigen::VectorXd::Zero(m.position.size()), both = one;
  pressure_load(m, pressure)(m.position, one, nullptr);
  for (auto const& s : uniform_pressure(m, Side::plus, 7)) pressure.push_back(s);
  pressure_load(m, pressure)(m.position, both, nullptr);
  EXPECT_LT(both.norm(), 1e-12 * one.norm());
}

TEST(Pressure, pushes_with_the_projected_area)
{
  auto const m = cap(core::Symmetry::axisymmetric);
  auto const pressure = uniform_pressure(m, Side::minus, 7);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
  pressure_load(m, pressure)(m.position, force, nullptr);
  double axial = 0;
  for (int a = 0; a < node_count(m); ++a) axial += force[2 * a];
  double const rim = m.position[m.position.size() - 1];
  double const exact = 7 * std::numbers::pi * rim * rim;
  EXPECT_NEAR(axial, exact, 1e-12 * exact);
}

TEST(Pressure, split_inside_an_element_adds_up_to_the_whole)
{
  auto const m = cap(core::Symmetry::axisymmetric);
  FacePressure const whole{{5, Side::plus, 0, 1, 2, 6}};
  FacePressure const parts{{5, Side::plus, 0, 0.3, 2, 3.2}, {5, Side::plus, 0.3, 1, 3.2, 6}};
  Eigen::VectorXd a = Eigen::VectorXd::Zero(m.position.size()), b = a;
  pressure_load(m, whole)(m.position, a, nullptr);
  pressure_load(m, parts)(m.position, b, nullptr);
  EXPECT_LT((a - b).norm(), 1e-12 * a.norm());
}

TEST(Thickness, keeps_the_volume_of_rubber)
{
  for (auto const symmetry : {core::Symmetry::planar, core::Symmetry::axisymmetric}) {
    auto const m = cap(symmetry);
    for (int e = 0; e < element_count(m); ++e) {
      auto const k = line_element(m, m.position, e);
      double const y = 0.5 * (m.position[2 * e + 1] + m.position[2 * e + 3]);
      double const now = core::ring(symmetry, y) * k.l * current_thickness(m, k, e);
      EXPECT_NEAR(now, k.A * m.thickness[e], 1e-12 * now);
    }
  }
}

TEST(Spring, presses_with_its_preload_and_gives_way)
{
  auto m = cap(core::Symmetry::axisymmetric);
  m.position = m.reference;
  Spring const spring{100, 14e-3, 4.868e-3, 0.333};
  auto const w = patch_weights(m, spring.radius);
  EXPECT_NEAR(w.sum(), 1, 1e-12);
  EXPECT_NEAR(spring_force(m, spring, w, m.position), -0.9132, 1e-12);
  for (int a = 0; a < node_count(m); ++a) m.position[2 * a] -= 1e-3;
  EXPECT_NEAR(spring_force(m, spring, w, m.position), -0.8132, 1e-12);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
  spring_load(m, spring)(m.position, force, nullptr);
  EXPECT_NEAR(force.sum(), -0.8132, 1e-12);
}

TEST(Spring, presses_a_sheet_as_it_does_a_membrane)
{
  Sheet s = make_sheet(disc_mesh(graded(0, 1, 9)), 0.1, neo_hookean_rubber(1), 1);
  Spring const spring{100, 14e-3, 4.868e-3, 1.0 / 3};  // the third ring's radius
  auto const w = patch_weights(s, spring.radius);
  EXPECT_NEAR(w.sum(), 1, 1e-12);
  double outside = 0;
  for (int a = 0; a < node_count(s); ++a)
    if (node3(s.reference, a).norm() > spring.radius * (1 + 1e-9)) outside += w[a];
  EXPECT_NEAR(outside, 0, 1e-12);
  for (int i : {1, 2}) {
    double centre = 0;
    for (int a = 0; a < node_count(s); ++a) centre += w[a] * node3(s.reference, a)[i];
    EXPECT_NEAR(centre, 0, 1e-12);
  }
  for (int a = 0; a < node_count(s); ++a) s.position[3 * a] -= 1e-3;
  EXPECT_NEAR(spring_force(s, spring, w, s.position), -0.8132, 1e-12);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(s.position.size());
  spring_load(s, spring)(s.position, force, nullptr);
  EXPECT_NEAR(force.sum(), -0.8132, 1e-12);
}

TEST(Spring, spreads_smoothly_with_its_radius)
{
  auto const m = cap(core::Symmetry::axisymmetric);
  for (double const radius : {0.3, 0.35}) {
    double const step = 1e-7;
    auto const jump = (patch_weights(m, radius + step) - patch_weights(m, radius - step)).eval();
    EXPECT_LT(jump.cwiseAbs().maxCoeff(), 20 * step);
  }
  Sheet const s = make_sheet(disc_mesh(graded(0, 1, 9)), 0.1, neo_hookean_rubber(1), 1);
  for (double const radius : {0.3, 0.35}) {
    double const step = 1e-7;
    auto const jump = (patch_weights(s, radius + step) - patch_weights(s, radius - step)).eval();
    EXPECT_LT(jump.cwiseAbs().maxCoeff(), 20 * step);
  }
}

}  // namespace
}  // namespace velum::structure
