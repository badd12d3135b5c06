// problem:   regions and pressure below a sheet whose nodes press by a given function of the place:
//            a ring that seals, with a gap, with a pocket in it, two rings, nothing; the meshes'
//            nodes are moved about
// reference: the side that each node is connected with; axial force on a flat disc of constant
//            pressures above, outside and inside, and of the lip's, none or linear in the radius
//            across the ring: its integral over the ring in closed form
// measure:   equality; relative error of the force, slope over 12, 24, 48 rings of triangles
// tolerance: exact; 0.1 % with 48 rings, order 2 +- 0.3
// why:       regions are a matter of yes or no; circles become polygons: second order
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ibm/region_pressure.hpp"
#include "structure/sheet_mesh.hpp"
#include "tests/support/order.hpp"

namespace velum::ibm {
namespace {

constexpr double r1 = 0.52, r2 = 0.67;

structure::TriangleMesh disc(int rings, double shake = 0.2)
{
  auto mesh = structure::disc_mesh(structure::graded(0, 1, rings));
  auto const rim = structure::rim_points(mesh);
  for (int i = 1; i < mesh.points.size() / 3; ++i) {
    if (std::ranges::binary_search(rim, i)) continue;
    mesh.points[3 * i + 1] += shake / rings * std::sin(37.0 * i);
    mesh.points[3 * i + 2] += shake / rings * std::sin(53.0 * i + 1);
  }
  return mesh;
}

/// Regions where a node at (r, angle) presses by this.
template <class Pressing>
SheetRegions regions_of(structure::TriangleMesh const& mesh, Pressing const& pressing)
{
  std::vector<double> p;
  for (int i = 0; i < mesh.points.size() / 3; ++i) {
    double const y = mesh.points[3 * i + 1], z = mesh.points[3 * i + 2];
    p.push_back(pressing(std::hypot(y, z), std::atan2(z, y)));
  }
  return find_regions(mesh.triangles, p, {structure::rim_points(mesh), {0}});
}

double ring(double r, double = 0) { return std::min(r - r1, r2 - r); }

/// What the place has below it where the ring seals.
Below expected(double r)
{
  if (ring(r) > 0) return Below::land;
  return r < r1 ? Below::downstream : Below::upstream;
}

void expect_sealed_ring(structure::TriangleMesh const& mesh, SheetRegions const& r)
{
  EXPECT_TRUE(r.touches);
  EXPECT_TRUE(r.sealed);
  for (int i = 0; i < mesh.points.size() / 3; ++i)
    EXPECT_EQ(r.node[static_cast<std::size_t>(i)],
              expected(std::hypot(mesh.points[3 * i + 1], mesh.points[3 * i + 2])))
        << i;
}

TEST(SheetRegions, are_parted_by_a_ring)
{
  for (int rings : {12, 30}) {
    auto const mesh = disc(rings);
    expect_sealed_ring(mesh, regions_of(mesh, ring));
  }
}

TEST(SheetRegions, are_joined_through_a_gap)
{
  auto const r = regions_of(disc(30), [](double radius, double angle) {
    return std::abs(angle - 1) < 0.2 ? -1 : ring(radius);
  });
  EXPECT_TRUE(r.touches);
  EXPECT_FALSE(r.sealed);
  for (auto below : r.node) EXPECT_NE(below, Below::downstream);
}

TEST(SheetRegions, count_a_pocket_as_land)
{
  auto const mesh = disc(30);
  expect_sealed_ring(mesh, regions_of(mesh, [](double r, double angle) {
                       bool const pocket = std::abs(angle - 1) < 0.3 && std::abs(r - 0.595) < 0.03;
                       return pocket ? -ring(r) : ring(r);
                     }));
}

TEST(SheetRegions, of_two_rings_enclose_land)
{
  auto const mesh = disc(30);
  auto const r = regions_of(mesh, [](double radius, double) {
    return std::max(std::min(radius - 0.3, 0.42 - radius), std::min(radius - 0.7, 0.82 - radius));
  });
  EXPECT_TRUE(r.sealed);
  for (int i = 0; i < mesh.points.size() / 3; ++i) {
    double const radius = std::hypot(mesh.points[3 * i + 1], mesh.points[3 * i + 2]);
    if (radius > 0.43 && radius < 0.69) {
      EXPECT_EQ(r.node[static_cast<std::size_t>(i)], Below::land) << i;
    }
  }
}

TEST(SheetRegions, are_one_where_nothing_touches)
{
  auto const r = regions_of(disc(12), [](double, double) { return -1.0; });
  EXPECT_FALSE(r.touches);
  EXPECT_FALSE(r.sealed);
  for (auto below : r.node) EXPECT_EQ(below, Below::upstream);
}

/// Force along the axis on a flat disc that is sealed by the ring.
double force(int rings, HydrostaticLoad const& load)
{
  auto const mesh = disc(rings, 0.1);
  auto const s = structure::make_sheet(mesh, 0.1, structure::neo_hookean_rubber(1), 1);
  auto const pressure = pressure_by_region(s, s.position, regions_of(mesh, ring), load);
  Eigen::VectorXd f = Eigen::VectorXd::Zero(s.position.size());
  structure::pressure_load(s, pressure)(s.position, f, nullptr);
  double sum = 0;
  for (int i = 0; i < f.size(); i += 3) sum += f[i];
  return sum;
}

double exact(HydrostaticLoad const& p)
{
  using std::numbers::pi;
  double lip = 0;
  if (p.lip == contact::LipPressure::linear) {
    // integral of (p_i + (p_o - p_i)(r - r1)/(r2 - r1)) 2 pi r dr
    double const slope = (p.outside - p.inside) / (r2 - r1);
    lip = pi * (p.inside - slope * r1) * (r2 * r2 - r1 * r1) +
          2 * pi / 3 * slope * (r2 * r2 * r2 - r1 * r1 * r1);
  }
  return -pi * p.above + pi * p.inside * r1 * r1 + lip + pi * p.outside * (1 - r2 * r2);
}

TEST(RegionPressure, has_the_force_of_its_regions)
{
  for (auto lip : {contact::LipPressure::none, contact::LipPressure::linear}) {
    HydrostaticLoad const load{1, 0.2, 0.9, lip};
    std::vector<double> size, error;
    for (int rings : {12, 24, 48}) {
      size.push_back(1.0 / rings);
      error.push_back(std::abs(force(rings, load) / exact(load) - 1));
    }
    EXPECT_LT(error.back(), 0.001);
    EXPECT_NEAR(tests::order(size, error), 2, 0.3);
    RecordProperty(lip == contact::LipPressure::none ? "none" : "linear",
                   std::to_string(error.back()));
    RecordProperty(lip == contact::LipPressure::none ? "order_none" : "order_linear",
                   std::to_string(tests::order(size, error)));
  }
}

TEST(RegionPressure, is_that_upstream_where_nothing_touches)
{
  auto const mesh = disc(12);
  auto const s = structure::make_sheet(mesh, 0.1, structure::neo_hookean_rubber(1), 1);
  auto const r = regions_of(mesh, [](double, double) { return -1.0; });
  auto const W = pressure_by_region(s, s.position, r, {1, 0.2, 0.9, contact::LipPressure::linear});
  EXPECT_NEAR((W.array() - 0.1 / 3).abs().maxCoeff(), 0, 1e-15);
}

}  // namespace
}  // namespace velum::ibm
