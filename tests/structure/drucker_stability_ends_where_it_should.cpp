// problem:    where laws of rubber stop to be stable
// reference:  neo-Hookean and Mooney-Rivlin of two positive coefficients never do; with c01 < 0 the
//             matrix dtau/dh of c10 and c01 in closed form, D11 = 4 (l1^2 + l3^2) (c10 + l2^2 c01),
//             D22 with 1 and 2 exchanged, D12 = 4 (l3^2 c10 + c01 / l3^2)
// measure:    ends of the range; the determinant of that matrix at the end, over D11^2
// tolerance:  1e-9
// why:        the end is bisected to 2^-40 of a step of half a percent
#include "structure/drucker.hpp"

#include <gtest/gtest.h>

namespace velum::structure {
namespace {

constexpr StretchRange searched{0.2, 10};

double determinant(MooneyRivlin const& m, TestMode mode, double l)
{
  auto const [l1, l2] = plane_stretch(mode, l);
  double const a = l1 * l1, b = l2 * l2, c = 1 / (a * b);
  double const d11 = (a + c) * (m.c10 + b * m.c01), d22 = (b + c) * (m.c10 + a * m.c01);
  double const d12 = c * m.c10 + m.c01 / c;
  return (d11 * d22 - d12 * d12) / (d11 * d11);
}

TEST(Drucker, holds_for_positive_coefficients)
{
  for (MooneyRivlin const m : {neo_hookean_rubber(1), MooneyRivlin{.c10 = 0.4, .c01 = 0.1}})
    for (auto const mode : all_test_modes) {
      auto const range = stable_range(m, mode, searched);
      EXPECT_EQ(range.from, searched.from);
      EXPECT_EQ(range.to, searched.to);
    }
}

TEST(Drucker, ends_where_the_determinant_vanishes)
{
  MooneyRivlin const m{.c10 = 0.5, .c01 = -0.05};
  for (auto const mode : all_test_modes) {
    auto const range = stable_range(m, mode, searched);
    EXPECT_LT(range.to, 4);
    EXPECT_GT(range.to, 1);
    EXPECT_NEAR(determinant(m, mode, range.to), 0, 1e-9);
    EXPECT_GT(determinant(m, mode, 1 + 0.99 * (range.to - 1)), 0);
  }
}

TEST(Drucker, fails_at_rest_without_stiffness)
{
  auto const range = stable_range({.c10 = 0.1, .c01 = -0.2}, TestMode::uniaxial, searched);
  EXPECT_EQ(range.from, 1);
  EXPECT_EQ(range.to, 1);
}

}  // namespace
}  // namespace velum::structure
