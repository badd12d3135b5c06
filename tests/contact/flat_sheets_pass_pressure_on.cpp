// problem:   contact patch test: a flat sheet of 8 x 8 squares on one of 6 x 6 (12 x 12, 8 x 8),
// each
//            square two triangles, on a rigid floor, pressed by 1e-3; penalty; both bodies' points,
//            1 to 4 parts per side
// reference: the same pressure everywhere: nodal forces pressure x area under uniform traction, and
//            as the floor's pressure in equilibrium
// measure:   largest error of a nodal force within the rim; largest of the floor's pressure;
//            resultant on the floor; order of the first in the parts per side
// tolerance: matching triangles 1e-9; resultant 1e-9; others: order 2 +- 0.3 over 1, 2, 4 parts,
//            floor's pressure within 10 % with 3 parts
// why:       points of one surface are a quadrature of the other's shape functions, which jump in
//            slope where they will: second order in the points' distance, exact where they fit;
//            forces sum up to the pressure's exactly. Seen: nodal forces 69, 17, 6, 5 % (6 x 6) and
//            175, 48, 13, 12 % (12 x 12), floor 21, 4, 4, 2 % and 85, 35, 7, 9 %
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ibm/sheet_contact.hpp"
#include "ibm/sheet_to_sheet.hpp"
#include "structure/merge_sheets.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/static_solve.hpp"
#include "tests/support/order.hpp"

namespace velum::tests {
namespace {

constexpr double H = 0.1, p = 1e-3, k = 1;

structure::Sheet square(int n, double x)
{
  auto s = structure::make_sheet(
      structure::strip_mesh(structure::graded(-1, 1, n), structure::graded(-1, 1, n)), H,
      structure::neo_hookean_rubber(1), 1);
  for (int a = 0; a < node_count(s); ++a) {
    s.reference[3 * a] = s.position[3 * a] = x;
    s.fixed[std::size_t(3 * a + 1)] = s.fixed[std::size_t(3 * a + 2)] = 1;
  }
  return s;
}

struct Patch {
  double force, floor, resultant;  // largest errors of the first two, relative
};

Patch press(int n, int m, int per_side)
{
  auto const upper = square(n, 1.5 * H), lower = square(m, 0.5 * H);
  auto s = structure::merge_sheets(upper, lower);
  auto const c = std::make_shared<contact::SurfaceContact>(
      ibm::make_sheet_to_sheet(s, k, {.per_side = per_side}));
  auto const floor = std::make_shared<contact::PointContact>(ibm::make_sheet_contact(
      s, [](core::Vec3 const& X) { return X[0]; }, k));
  std::array const loads{ibm::contact_load(c), ibm::contact_load(floor)};
  Eigen::VectorXd const area = structure::nodal_area(s);

  for (int a = 0; a < node_count(upper); ++a) s.position[3 * a] -= p / k;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(s.position.size());
  loads[0](s.position, force, nullptr);
  Patch r{0, 0, 0};
  for (int a = 0; a < node_count(s); ++a)
    if (s.reference.segment<2>(3 * a + 1).cwiseAbs().maxCoeff() < 0.999)
      r.force = std::max(r.force, std::abs(std::abs(force[3 * a]) / (p * area[a]) - 1));

  for (int a = 0; a < node_count(s); ++a) s.position[3 * a] -= p / k;
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(element_count(s));
  pressure.head(element_count(upper)).setConstant(p);
  std::array const all{structure::pressure_load(s, pressure), loads[0], loads[1]};
  c->hold = true;
  for (int round = 0; round < 4; ++round) {
    follow(*c, ibm::node_places(s.position));
    structure::static_solve(s, all);
  }
  auto const places = ibm::node_places(s.position);
  for (int a = node_count(upper); a < node_count(s); ++a)
    r.floor = std::max(
        r.floor,
        std::abs(contact::touch(*floor, std::size_t(a), places[std::size_t(a)]).traction / p - 1));
  r.resultant = sum_up(*floor, places).force[0];
  return r;
}

TEST(FlatSheets, pass_pressure_on_exactly_where_their_triangles_match)
{
  auto const r = press(8, 8, 2);
  EXPECT_LT(r.force, 1e-9);
  EXPECT_LT(r.floor, 1e-9);
}

TEST(FlatSheets, pass_pressure_on_to_second_order_in_the_distance_of_their_points)
{
  for (int const m : {6, 12}) {
    std::vector<double> parts, error;
    for (int const per_side : {1, 2, 3, 4}) {
      auto const r = press(8, m, per_side);
      EXPECT_NEAR(r.resultant / (4 * p), 1, 1e-9) << m << " " << per_side;
      if (per_side == 3) {
        EXPECT_LT(r.floor, 0.1) << m;
        continue;
      }
      parts.push_back(1.0 / per_side);
      error.push_back(r.force);
    }
    EXPECT_NEAR(order(parts, error), 2, 0.3) << m;
  }
}

}  // namespace
}  // namespace velum::tests
