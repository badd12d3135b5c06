// problem:   a step of given length by explicit sub-steps or implicitly; inflated discs of line
//            elements and of triangles, with and without damping by stiffness
// reference: the rule, as many sub-steps as an implicit step costs; wall times measured here
// measure:   choice, sub-steps and sentence; typical over measured ratio of costs
// tolerance: exact; a factor of 5, in one of eight tries
// why:       the fit is good to a factor of two on a quiet machine; a busy one may double a time
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/check.hpp"
#include "structure/mass.hpp"
#include "structure/pressure_load.hpp"
#include "structure/scheme.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/stable_step.hpp"
#include "structure/static_solve.hpp"

namespace velum::structure {
namespace {

TEST(Scheme, is_explicit_up_to_the_cost_of_an_implicit_step)
{
  // 0.8 of the stable step, so many times
  auto const of = [](double substeps) { return choose_scheme(0.8 * substeps, 1, 50); };
  EXPECT_EQ(of(0.5).scheme, TimeScheme::explicit_substeps);
  EXPECT_EQ(of(0.5).substeps, 1);
  EXPECT_EQ(of(50).scheme, TimeScheme::explicit_substeps);
  EXPECT_EQ(of(50).substeps, 50);
  EXPECT_EQ(of(50.5).scheme, TimeScheme::implicit);
  EXPECT_EQ(of(50.5).substeps, 1);
  EXPECT_EQ(of(1e15).scheme, TimeScheme::implicit);
  // one sub-step is never dearer
  EXPECT_EQ(choose_scheme(0.5, 1, 0.1).scheme, TimeScheme::explicit_substeps);
  auto const loose = choose_scheme(1, std::numeric_limits<double>::infinity(), 50);
  EXPECT_EQ(loose.scheme, TimeScheme::explicit_substeps);
  EXPECT_EQ(loose.substeps, 1);
}

TEST(Scheme, says_what_it_is_and_why)
{
  auto const few = choose_scheme(8e-6, 1e-6, 50).sentence;
  EXPECT_EQ(few,
            "explicit, 10 sub-steps to a step of 8e-06 s (stable up to 1e-06 s): an implicit step "
            "costs as much as 50");
  auto const many = choose_scheme(8e-3, 1e-6, 50).sentence;
  EXPECT_NE(many.find("implicit, generalised-alpha, one step of 0.008 s"), std::string::npos);
  EXPECT_NE(many.find("1e+04 explicit sub-steps"), std::string::npos) << many;
  EXPECT_NE(many.find("period below 0.16 s is not resolved"), std::string::npos) << many;
}

TEST(Scheme, refuses_a_step_that_is_not_positive)
{
  EXPECT_THROW(choose_scheme(0, 1, 50), core::InputError);
  EXPECT_THROW(choose_scheme(1, 0, 50), core::InputError);
  EXPECT_THROW(choose_scheme(1, 1, -1), core::InputError);
  EXPECT_THROW(choose_scheme(std::numeric_limits<double>::quiet_NaN(), 1, 50), core::InputError);
}

constexpr double a = 8.25e-3, H = 2e-3, pressure = 50e3;
constexpr int tries = 8;  // a neighbour on the machine disturbs some of them
constexpr Rayleigh dampings[] = {{0.5, 0}, {0.5, 5e-3}};

template <class Body>
void expect_typical(Body const& body, std::span<Load const> loads)
{
  double const stable = stable_step(body, lumped_mass(body), body.position);
  for (auto const& damping : dampings) {
    double const typical = typical_cost_ratio(body, damping);
    double measured = 0, off = std::numeric_limits<double>::infinity();
    for (int k = 0; k < tries && off > std::log(5); ++k) {
      double const now = measured_cost_ratio(body, damping, 100 * stable, stable, loads);
      if (std::abs(std::log(now / typical)) >= off) continue;
      measured = now;
      off = std::abs(std::log(now / typical));
    }
    EXPECT_LT(measured, 5 * typical);
    EXPECT_GT(measured, typical / 5);
    testing::Test::RecordProperty(
        std::string(damping.beta > 0 ? "damped_" : "undamped_") + std::to_string(node_count(body)),
        std::to_string(measured));
  }
}

TEST(Scheme, has_the_typical_cost_on_lines)
{
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, a, a / 80, [](double) { return H; },
                          neo_hookean_rubber(0.946e6), 1140});
  auto p = uniform_pressure(m, Side::minus, pressure);
  std::array const loads{pressure_load(m, p)};
  static_solve(m, loads);
  for (auto& s : p) s.p_from = s.p_to = 1.1 * pressure;  // sets it going
  expect_typical(m, loads);
}

TEST(Scheme, has_the_typical_cost_on_triangles)
{
  auto const mesh = disc_mesh(graded(0, a, 12));
  Sheet s = make_sheet(mesh, H, neo_hookean_rubber(0.946e6), 1140);
  for (int n : rim_points(mesh)) clamp(s, n);
  Eigen::VectorXd p = Eigen::VectorXd::Constant(element_count(s), -pressure);
  std::array const loads{pressure_load(s, p)};
  static_solve(s, loads);
  p *= 1.1;  // sets it going
  expect_typical(s, loads);
}

}  // namespace
}  // namespace velum::structure
