// problem:   a small flat sheet above a large one of the same thickness, moved through it by hand
// to
//            0.4 and 3 thicknesses below, at once and with follow() in between; moved beside its
//            rim and below
// reference: the signed distance along the normal
// measure:   largest penetration, force on the small sheet; the same of a contact that first saw
// the
//            sheets so
// tolerance: 1e-12 of the thickness; the sign
// why:       flat sheets: exact but for round-off
#include <gtest/gtest.h>

#include <cmath>

#include "core/check.hpp"
#include "ibm/sheet_contact.hpp"
#include "ibm/sheet_to_sheet.hpp"
#include "structure/merge_sheets.hpp"
#include "structure/sheet_mesh.hpp"

namespace velum::tests {
namespace {

constexpr double H = 0.1;

structure::Sheet square(double side, int n, double x)
{
  auto s = structure::make_sheet(
      structure::strip_mesh(structure::graded(-side, side, n), structure::graded(-side, side, n)),
      H, structure::neo_hookean_rubber(1), 1);
  for (int a = 0; a < node_count(s); ++a) s.reference[3 * a] = s.position[3 * a] = x;
  return s;
}

structure::Sheet small_above_large(double x)
{
  return structure::merge_sheets(square(0.3, 3, x), square(1, 7, 0));
}

std::vector<core::Vec3> places(double x, double aside = 0)
{
  auto s = small_above_large(x);
  for (int a = 0; a < 16; ++a) s.position[3 * a + 1] += aside;
  return ibm::node_places(s.position);
}

TEST(Sides, are_kept_by_what_was_pushed_through)
{
  for (double const x : {-0.4 * H, -3 * H})
    for (bool const step_by_step : {false, true}) {
      auto c = ibm::make_sheet_to_sheet(small_above_large(1.2 * H), 1);
      for (double at = 1.2 * H; step_by_step && at > x; at -= 0.1 * H) follow(c, places(at));
      cover(c, places(x));
      auto const sum = sum_up(c, places(x));
      EXPECT_NEAR(sum.penetration, H - x, 1e-12 * H) << x << " " << step_by_step;
      EXPECT_GT(sum.force[0], 0) << x << " " << step_by_step;
    }
  auto const fresh = ibm::make_sheet_to_sheet(small_above_large(-0.4 * H), 1);
  EXPECT_LT(sum_up(fresh, places(-0.4 * H)).force[0], 0);
}

TEST(Sides, are_told_anew_beyond_the_rim)
{
  auto c = ibm::make_sheet_to_sheet(small_above_large(1.2 * H), 1);
  for (int n = 1; n <= 50; ++n) follow(c, places(1.2 * H, 0.04 * n));
  for (int n = 1; n <= 30; ++n) follow(c, places((1.2 - 0.08 * n) * H, 2));
  for (int n = 50; n >= 0; --n) follow(c, places(-1.2 * H, 0.04 * n));
  EXPECT_EQ(sum_up(c, places(-1.2 * H)).area, 0);
  EXPECT_LT(sum_up(c, places(-0.9 * H)).force[0], 0);
}

TEST(SurfaceContact, says_what_it_cannot_do)
{
  auto const one = square(1, 2, 0);
  EXPECT_THROW(ibm::make_sheet_to_sheet(one, 0), core::InputError);
  EXPECT_THROW(ibm::make_sheet_to_sheet(one, 1, {contact::Passes::first}), core::InputError);
  EXPECT_THROW(ibm::make_sheet_to_sheet(one, 1, {.per_side = 0}), core::InputError);
  auto other = one;
  other.density = 2;
  EXPECT_THROW(structure::merge_sheets(one, other), core::InputError);
}

}  // namespace
}  // namespace velum::tests
