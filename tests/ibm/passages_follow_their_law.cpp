// problem:    flow through an orifice, a slit and the gap between a disc and a ring seat
// reference:  orifice: Q = Cd A sqrt(2 dp / rho) with 1/Cd^2 = 1/C^2 (1 + Re_t/Re); Stokes flow at
//             low Re; plane Poiseuille, q = h^3 dp / (12 mu L); between parallel discs, where
//             friction rules, dp = 6 mu Q ln(R2/R1) / (pi h^3) (Savage 1964, methods.md C11)
// measure:    flow over pressure difference, discharge coefficient, resistance
// tolerance:  1e-12 for what is algebra; 1e-3 for the discs; 1 % for the limits of Cd; 1e-3 for the
//             sections beside a land of 0.1 mm below a membrane of 4 mm, distances from its edges
// why:        the ring is summed over 40 elements whose mean radius stands for 1/r: second order in
//             1/40 of a decade; the limits are approached like Re_t/Re
#include "ibm/loss.hpp"
#include "ibm/seat_gap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velum::ibm {
namespace {

constexpr Liquid water{998, 1e-6};

TEST(Passage, flow_is_the_inverse_of_the_loss)
{
  for (Loss const loss : {Loss{3, 0}, Loss{0, 5}, Loss{2, 7}, Loss{1e9, 1e-3}, Loss{1e-6, 1e3}})
    for (double const q : {1e-8, 0.3, -4.0, 1e5}) {
      double const dp = loss.viscous * q + loss.inertial * std::abs(q) * q;
      EXPECT_NEAR(flow(loss, dp), q, 1e-12 * std::abs(q));
      double const h = 1e-6 * std::abs(dp);
      EXPECT_NEAR((flow(loss, dp + h) - flow(loss, dp - h)) / (2 * h), slope(loss, q),
                  1e-6 * slope(loss, q));
    }
  EXPECT_EQ(flow({0, 0}, 0.0), 0);
}

TEST(Passage, discharge_falls_at_low_reynolds_numbers)
{
  double const d = 1e-3, area = std::numbers::pi * d * d / 4, C = 0.7, transition = 30;
  Loss const loss = orifice_loss(water, area, d, C, transition);
  for (double const Re : {0.01, 1.0, 30.0, 1e3, 1e5}) {
    double const Q = Re * area * water.viscosity / d;
    double const dp = loss.viscous * Q + loss.inertial * Q * Q;
    double const Cd = Q / (area * std::sqrt(2 * dp / water.density));
    EXPECT_NEAR(Cd, C / std::sqrt(1 + transition / Re), 1e-12);
    if (Re >= 1e5) {
      EXPECT_NEAR(Cd, C, 1e-2 * C);
    }
    if (Re <= 0.01) {
      EXPECT_NEAR(Cd, C * std::sqrt(Re / transition), 1e-2 * Cd);
    }
  }
}

TEST(Passage, slit_is_poiseuille_flow_and_a_velocity_head)
{
  double const b = 0.03, h = 1e-4, L = 5e-4, C = 0.7;
  Loss const loss = slit_loss(water, b, h, L, C);
  double const mu = water.density * water.viscosity;
  EXPECT_NEAR(loss.viscous, 12 * mu * L / (b * h * h * h), 1e-12 * loss.viscous);
  double const u = 3, Q = u * b * h;
  EXPECT_NEAR(loss.inertial * Q * Q, water.density / 2 * u * u / (C * C), 1e-9);
}

SeatContact flat_on_ring(double gap, int elements, core::Symmetry symmetry)
{
  double const H = 1e-3, R1 = 5e-3, R2 = 5.5e-3;
  auto m =
      structure::flat_membrane({symmetry, R1, R2, (R2 - R1) / elements, [=](double) { return H; },
                                structure::neo_hookean_rubber(1e6), 1000, 0});
  auto const seat = core::box({-1, 0}, {-H / 2 - gap, 1});
  return make_seat_contact(seat, 1e9, m);
}

SeatGap gap_of(double gap, core::Symmetry symmetry = core::Symmetry::axisymmetric)
{
  auto seat = flat_on_ring(gap, 40, symmetry);
  structure::FlatShape const shape{symmetry,
                                   5e-3,
                                   5.5e-3,
                                   5e-4 / 40,
                                   [](double) { return 1e-3; },
                                   structure::neo_hookean_rubber(1e6),
                                   1000,
                                   0};
  auto const membrane = structure::flat_membrane(shape);
  press(seat, membrane.position);
  return seat_gap({water, 0.7, 1e-6}, seat, membrane);
}

TEST(SeatGap, is_that_between_parallel_discs)
{
  double const h = 2e-5, mu = water.density * water.viscosity;
  auto const gap = gap_of(h);
  ASSERT_TRUE(gap.loss);
  EXPECT_NEAR(gap.least, h, 1e-12);
  double const exact = 6 * mu * std::log(5.5 / 5.0) / (std::numbers::pi * h * h * h);
  EXPECT_NEAR(gap.loss->viscous, exact, 1e-3 * exact);
  auto const plane = gap_of(h, core::Symmetry::planar);
  EXPECT_NEAR(plane.loss->viscous, 12 * mu * 5e-4 / (h * h * h), 1e-9 * plane.loss->viscous);
}

TEST(SeatGap, seals_below_its_roughness)
{
  EXPECT_TRUE(gap_of(1.1e-6).loss);
  EXPECT_FALSE(gap_of(0.9e-6).loss);
  EXPECT_FALSE(gap_of(-1e-6).loss);
}

TEST(SeatGap, pressure_falls_from_outside_to_inside)
{
  auto const narrow = gap_of(2e-6), wide = gap_of(2e-4);
  for (auto const& gap : {narrow, wide})
    for (double const Q : {1e-5, -1e-5}) {
      auto const share = outside_share(gap, Q);
      for (std::size_t a = 1; a < share.size(); ++a) EXPECT_GE(share[a], share[a - 1] - 1e-12);
      EXPECT_GE(share.front(), -1e-12);
      EXPECT_LE(share.back(), 1 + 1e-12);
    }
  // friction alone: half the fall over half the land; inertia alone: the square of the sections
  EXPECT_NEAR(outside_share(narrow, 1e-9)[20], 0.5, 0.03);
  EXPECT_NEAR(outside_share(wide, 1e-4)[20], 1 - std::pow(5 / 5.25, 2), 0.02);
}

TEST(SeatGap, widens_beside_the_land_of_a_thick_membrane)
{
  double const H = 4e-3, h = 8e-5;
  auto const symmetry = core::Symmetry::axisymmetric;
  auto const m =
      structure::flat_membrane({symmetry, 4.7e-3, 5.5e-3, 1e-5, [=](double) { return H; },
                                structure::neo_hookean_rubber(1e6), 1000, 0});
  auto seat = make_seat_contact(core::box({-1, 4.8e-3}, {-H / 2 - h, 4.9e-3}), 1e9, m);
  press(seat, m.position);
  auto const gap = seat_gap({water, 0.7, 1e-6}, seat, m);
  EXPECT_NEAR(gap.least, h, 1e-12);
  EXPECT_GE(gap.at[1], 4.8e-3);
  EXPECT_LE(gap.at[1], 4.9e-3);
  for (int a = 0; a < structure::node_count(m); ++a) {
    double const r = m.reference[2 * a + 1], beside = std::max({4.8e-3 - r, r - 4.9e-3, 0.0});
    double const share = gap.at[1] * h / (r * std::hypot(beside, h));
    EXPECT_NEAR(gap.narrowness[static_cast<std::size_t>(a)], std::min(share * share, 1.0), 1e-3)
        << r;
  }
}

}  // namespace
}  // namespace velum::ibm
