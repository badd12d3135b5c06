// problem:    one marker near a box with rounded corners and near a disc, penalty and multiplier
// reference:  central differences of the force; E = k/2 A <-g>^2 of the penalty law
// measure:    tangent against differences over its largest entry; force against -dE/dX
// tolerance:  1e-5
// why:        the curvature comes from normals 1e-4 apart, where it is constant; steps of 1e-6
//             leave 1e-9 of round-off; a missing curvature term would show as 1e-1
#include "contact/contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velum::contact {
namespace {

core::Markers marker_at(core::Vec2 const& X)
{
  return {.X = {X}, .V = {{}}, .F = {{}}, .area = {0.3}, .offset = {0.5}};
}

core::Vec2 force_at(Contact const& c, core::Vec2 const& X)
{
  auto markers = marker_at(X);
  add_forces(c, markers);
  return markers.F[0];
}

double energy_at(Contact const& c, core::Vec2 const& X)
{
  double const g = gap(c, marker_at(X), 0);
  return g < 0 ? 0.5 * c.stiffness * 0.3 * g * g : 0;
}

TEST(ContactForce, is_the_same_where_markers_out_of_reach_are_spared)
{
  Contact const corner{
      core::subtract(core::box({-2, -2}, {0, 0}, 0.3), core::disc({-1, 0}, 0.5)), 50, {}};
  Clearance clearance;
  int touching = 0;
  for (int n = 0; n < 2000; ++n) {
    // comes near and goes again, fast and slowly
    auto spared = marker_at({1.5 * std::cos(0.05 * n) - 1, 0.7 + 0.6 * std::sin(0.37 * n)});
    auto all = spared;
    if (n % 100 == 50) spared.offset[0] = all.offset[0] = 0.4;
    add_forces(corner, spared, clearance);
    add_forces(corner, all);
    EXPECT_EQ(spared.F[0][0], all.F[0][0]);
    EXPECT_EQ(spared.F[0][1], all.F[0][1]);
    touching += all.F[0][1] != 0;
  }
  EXPECT_GT(touching, 100);
  EXPECT_LT(touching, 1900);
}

TEST(ContactForce, is_the_energy_gradient_and_has_the_exact_tangent)
{
  Contact const corner{core::box({-2, -2}, {0, 0}, 0.3), 50, {}};
  Contact const ball{core::disc({0, 0}, 1), 50, {4}};
  struct Sample {
    Contact contact;
    core::Vec2 X;
  };
  double const step = 1e-6;
  for (auto const& [c, X] : {Sample{corner, {0.4, -1}}, Sample{corner, {0.15, 0.3}},
                             Sample{corner, {0.05, 0.35}}, Sample{ball, {0.9, 1.1}}}) {
    std::vector<SymmetricBlock> blocks;
    tangents(c, marker_at(X), 1e-4, blocks);
    double const entries[2][2] = {{blocks[0].xx, blocks[0].xy}, {blocks[0].xy, blocks[0].yy}};
    double const size = std::abs(blocks[0].xx) + std::abs(blocks[0].yy);
    ASSERT_GT(size, 0);
    for (int j = 0; j < 2; ++j) {
      core::Vec2 plus = X, minus = X;
      plus[j] += step, minus[j] -= step;
      auto const slope = (0.5 / step) * (force_at(c, plus) - force_at(c, minus));
      for (int i = 0; i < 2; ++i) EXPECT_NEAR(entries[i][j], slope[i], 1e-5 * size);
      if (!c.multiplier.empty()) continue;
      double const rise = (energy_at(c, plus) - energy_at(c, minus)) / (2 * step);
      EXPECT_NEAR(force_at(c, X)[j], -rise, 1e-6 * size);
    }
  }
}

TEST(ContactForce, vanishes_out_of_contact)
{
  Contact const c{core::disc({0, 0}, 1), 50, {}};
  EXPECT_EQ(norm(force_at(c, {0, 1.6})), 0);
}

}  // namespace
}  // namespace velum::contact
