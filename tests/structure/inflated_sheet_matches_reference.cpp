// problem:   clamped flat disc of rubber, inflated from one side, no bending, of triangles; by
//            pressure, and by volume past the limit point
// reference: p a/(mu H) against w0/a and V/a^3, neo-Hookean and Mooney-Rivlin with c01/c10 = 0.1
//            and 0.2; shooting (two codes) and energy minimisation agree to the four digits given;
//            limit point 1.879; of the orders and of the place of the limit point, 640 line
//            elements
// measure:   relative error with 32 rings of triangles, 24 for Mooney-Rivlin; slopes of the errors
//            of V and of the nodes' places (root of the mean square) over 6, 12 and 24 rings
// tolerance: 0.2 % of w0, V and the limit pressure, 1 % of the limit's w0; order 2 +- 0.1
// why:       linear triangles are second order: 32 rings err by 0.15 % at the largest loads; the
//            table's last digit is 0.06 % at the smallest; the limit is read from a parabola
//            through three pressures
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "structure/pressure_load.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/static_solve.hpp"
#include "structure/volume_control.hpp"
#include "tests/support/order.hpp"

namespace velum::structure {
namespace {

constexpr double mu = 0.946e6, H = 1e-3, a = 8.25e-3;

Sheet inflated(double load, double ratio, int rings)
{
  auto const mesh = disc_mesh(graded(0, a, rings));
  Sheet s = make_sheet(mesh, H, {.c10 = mu / 2, .c01 = ratio * mu / 2}, 1140);
  for (int p : rim_points(mesh)) clamp(s, p);
  Eigen::VectorXd const pressure = Eigen::VectorXd::Constant(element_count(s), -load * mu * H / a);
  std::array const loads{pressure_load(s, pressure)};
  static_solve(s, loads);
  return s;
}

TEST(InflatedSheet, matches_reference_in_deflection_and_volume)
{
  struct Row {
    double load, w0, volume;
  };
  for (auto const& row : {Row{0.01, 0.0896, 0.1458}, Row{0.10, 0.1992, 0.3282},
                          Row{0.50, 0.3743, 0.6398}, Row{1.50, 0.7191, 1.3881}}) {
    auto const s = inflated(row.load, 0, 32);
    EXPECT_NEAR(s.position[0] / a / row.w0, 1, 0.002) << row.load;
    EXPECT_NEAR(swept_volume(s, s.position) / (a * a * a) / row.volume, 1, 0.002) << row.load;
  }
}

TEST(InflatedSheet, matches_reference_of_mooney_and_rivlin)
{
  struct Row {
    double load, ratio, w0;
  };
  for (auto const& row : {Row{0.10, 0.1, 0.1923}, Row{0.10, 0.2, 0.1863}, Row{1.00, 0.1, 0.4962},
                          Row{1.50, 0.2, 0.5890}})
    EXPECT_NEAR(inflated(row.load, row.ratio, 24).position[0] / a / row.w0, 1, 0.002)
        << row.load << " " << row.ratio;
}

/// Of 640 line elements.
Membrane line(double load)
{
  auto m = flat_membrane({core::Symmetry::axisymmetric, 0, a, a / 640, [](double) { return H; },
                          neo_hookean_rubber(mu), 1140});
  auto const pressure = uniform_pressure(m, Side::minus, load * mu * H / a);
  std::array const loads{pressure_load(m, pressure)};
  static_solve(m, loads);
  return m;
}

/// Position of the line's point of reference radius R.
core::Vec2 at_radius(Membrane const& m, double R)
{
  double const place = std::min(R / a, 1.0) * element_count(m);
  int const e = std::min(static_cast<int>(place), element_count(m) - 1);
  return node(m.position, e) + (place - e) * (node(m.position, e + 1) - node(m.position, e));
}

/// Root of the mean square distance of the sheet's nodes from the surface of revolution.
double distance(Sheet const& s, Membrane const& exact)
{
  Eigen::VectorXd const area = nodal_area(s);
  double sum = 0;
  for (int i = 0; i < node_count(s); ++i) {
    auto const R = node3(s.reference, i), x = node3(s.position, i);
    auto const e = at_radius(exact, R.norm());
    sum += area[i] * (std::pow(x[0] - e[0], 2) + std::pow(std::hypot(x[1], x[2]) - e[1], 2));
  }
  return std::sqrt(sum / area.sum());
}

TEST(InflatedSheet, is_second_order_in_the_size_of_triangles)
{
  auto const exact = line(1);
  double const volume = inflation(exact).volume(exact.position);
  std::vector<double> size, error_of_place, error_of_volume;
  for (int rings : {6, 12, 24}) {
    auto const s = inflated(1, 0, rings);
    size.push_back(1.0 / rings);
    error_of_place.push_back(distance(s, exact));
    error_of_volume.push_back(std::abs(swept_volume(s, s.position) - volume));
  }
  EXPECT_NEAR(tests::order(size, error_of_volume), 2, 0.1);
  EXPECT_NEAR(tests::order(size, error_of_place), 2, 0.1);
}

TEST(InflatedSheet, passes_the_limit_point_by_volume)
{
  Sheet s = inflated(1.5, 0, 32);
  auto const by = inflation(s);
  double const unit = mu * H / a;
  double pressure = 1.5 * unit;
  std::vector<double> p, w0;
  for (double V = 1.8; V < 3.7; V += 0.3) {
    pressure = solve_at_volume(s, by, V * a * a * a, pressure).pressure;
    p.push_back(pressure / unit);
    w0.push_back(s.position[0] / a);
  }
  auto const top = static_cast<std::size_t>(std::ranges::max_element(p) - p.begin());
  ASSERT_TRUE(top > 0 && top + 1 < p.size());
  // the vertex of the parabola through the three largest
  double const left = p[top] - p[top - 1], right = p[top + 1] - p[top];
  double const at = (left + right) / 2 / (left - right);
  double const slope = (w0[top + 1] - w0[top - 1]) / 2;
  EXPECT_NEAR(p[top] + (left + right) / 4 * at, 1.8792, 0.002 * 1.8792);
  EXPECT_NEAR(w0[top] + slope * at, 1.1748, 0.01 * 1.1748);
}

}  // namespace
}  // namespace velum::structure
