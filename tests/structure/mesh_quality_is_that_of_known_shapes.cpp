// problem:   quality of meshes whose angles, sizes and holes are known; the stable step of a sheet
//            with a row of ever thinner triangles, and with two of them amid thick ones
// reference: equilateral triangles: shape 1, angles 60; the triangle of sides 3, 4, 5; loops of
//            rims counted by hand; 1 / omega with omega^2 = k / m, where k goes with 1 / height,
//            and m with the height in a row, or not at all amid thick triangles: orders 1 and 1/2
// measure:   the figures; the sentences; the order of the step in the smallest height
// tolerance: 1e-12 for figures; 0.05 for the order
// why:       the figures are a few operations; the orders hold for vanishing height: at 1/25 to
//            1/100 of the size other terms are left
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.hpp"
#include "structure/mesh_quality.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/stable_step.hpp"
#include "tests/support/order.hpp"

namespace velum::structure {
namespace {

/// One triangle in the plane z = 0.
TriangleMesh single(double ax, double ay, double bx, double by, double cx, double cy)
{
  TriangleMesh mesh{Eigen::VectorXd(9), {{0, 1, 2}}};
  mesh.points << ax, ay, 0, bx, by, 0, cx, cy, 0;
  return mesh;
}

/// A sheared grid of equilateral triangles with sides of 2 mm.
TriangleMesh equilateral()
{
  auto mesh = strip_mesh(graded(0, 5, 5), graded(0, 4, 4));
  int const columns = 5;
  mesh.triangles.clear();
  for (int r = 0; r < 5; ++r)
    for (int c = 0; c < 4; ++c) {
      int const a = r * columns + c, b = a + columns;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({b, b + 1, a + 1});
    }
  for (int p = 0; p < mesh.points.size() / 3; ++p) {
    double const row = mesh.points[3 * p + 1], column = mesh.points[3 * p + 2];
    mesh.points.segment<3>(3 * p) << 0.5e-3, 2e-3 * (row + column / 2),
        std::numbers::sqrt3 * 1e-3 * column;
  }
  return mesh;
}

bool says(std::vector<std::string> const& sentences, std::string const& words)
{
  return std::ranges::any_of(sentences, [&](std::string const& sentence) {
    return sentence.find(words) != std::string::npos;
  });
}

TEST(MeshQuality, of_equilateral_triangles_is_one)
{
  auto const q = mesh_quality(equilateral());
  EXPECT_NEAR(q.worst_shape.value, 1, 1e-12);
  EXPECT_NEAR(q.mean_shape, 1, 1e-12);
  EXPECT_NEAR(q.smallest_angle.value, 60, 1e-11);
  EXPECT_NEAR(q.largest_angle.value, 60, 1e-11);
  EXPECT_NEAR(q.shortest_edge, 2e-3, 1e-15);
  EXPECT_NEAR(q.longest_edge, 2e-3, 1e-15);
  EXPECT_NEAR(q.mean_edge, 2e-3, 1e-15);
  EXPECT_NEAR(q.smallest_height.value, std::numbers::sqrt3 * 1e-3, 1e-15);
  EXPECT_NEAR(q.size_jump.value, 1, 1e-12);
  EXPECT_NEAR(q.area, 40 * std::numbers::sqrt3 * 1e-6, 1e-17);
  EXPECT_TRUE(warnings(q).empty());
}

TEST(MeshQuality, of_a_right_triangle_is_as_calculated)
{
  auto const q = mesh_quality(single(0, 0, 3, 0, 3, 4));
  double const degree = std::numbers::pi / 180;
  EXPECT_NEAR(q.worst_shape.value, 4 * std::numbers::sqrt3 * 6 / 50, 1e-12);
  EXPECT_NEAR(q.smallest_angle.value, std::atan2(3, 4) / degree, 1e-12);
  EXPECT_NEAR(q.largest_angle.value, 90, 1e-12);
  EXPECT_NEAR(q.smallest_height.value, 2.4, 1e-12);
  EXPECT_NEAR(q.mean_edge, 4, 1e-12);
  EXPECT_NEAR((q.worst_shape.place - Eigen::Vector3d(2, 4.0 / 3, 0)).norm(), 0, 1e-12);
}

TEST(MeshQuality, names_the_worst_triangle_and_the_largest_jump)
{
  auto mesh = strip_mesh({0, 1, 2, 2.25}, {0, 1, 2});
  auto const q = mesh_quality(mesh);
  EXPECT_GE(q.worst_shape.triangle, 8);  // of the last row
  EXPECT_NEAR(q.smallest_angle.value, std::atan(0.25) * 180 / std::numbers::pi, 1e-12);
  double const coarse = std::sqrt(1 + 1 + 2), fine = std::sqrt(1 + 0.0625 + 1.0625);
  EXPECT_NEAR(q.size_jump.value, coarse / fine, 1e-12);
  EXPECT_TRUE(says(warnings(q), "the smallest angle is 14.0 degrees, below 15, of triangle 8 at"));
}

TEST(MeshQuality, counts_parts_and_rims)
{
  struct Row {
    TriangleMesh mesh;
    int parts, rims;
    bool closed;
  };
  auto const strip = strip_mesh(graded(0, 1, 4), graded(0, 1, 4));
  auto two = strip;
  for (auto const& t : strip.triangles) two.triangles.push_back({t[0] + 25, t[1] + 25, t[2] + 25});
  two.points.conservativeResize(150);
  two.points.tail<75>() = strip.points.array() + 3;
  TriangleMesh octahedron{Eigen::VectorXd(18), {}};
  octahedron.points << 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1;
  for (int x : {0, 1})
    for (int y : {2, 3})
      for (int z : {4, 5})
        octahedron.triangles.push_back((x + y + z) % 2 == 0 ? Triangle{x, y, z}
                                                            : Triangle{x, z, y});
  // a hole of one square that meets the rim in a point: around it the one goes over into the other
  auto pinched = strip;
  for (int const square : {5, 0})
    pinched.triangles.erase(pinched.triangles.begin() + 2 * square,
                            pinched.triangles.begin() + 2 * square + 2);
  TriangleMesh const touching{Eigen::VectorXd::LinSpaced(15, 0, 1), {{0, 1, 2}, {2, 3, 4}}};
  for (auto const& row :
       {Row{strip, 1, 1, false}, Row{two, 2, 2, false}, Row{octahedron, 1, 0, true},
        Row{tube_mesh(1, {0, 1}, 6), 1, 2, false}, Row{annulus_mesh({1, 2}, 9), 1, 2, false},
        Row{pinched, 1, 1, false}, Row{touching, 2, 2, false}}) {
    auto const q = mesh_quality(row.mesh);
    EXPECT_EQ(q.parts, row.parts);
    EXPECT_EQ(q.rims, row.rims);
    EXPECT_EQ(q.closed, row.closed);
    EXPECT_EQ(q.flipped_edges, 0);
    EXPECT_EQ(q.crowded_edges, 0);
    EXPECT_EQ(says(warnings(q), "parts that no edge joins"), row.parts > 1);
  }
}

TEST(MeshQuality, warns_of_faults_in_the_surface)
{
  auto const good = strip_mesh({0, 1, 2}, {0, 1, 2});
  auto flipped = good;
  std::swap(flipped.triangles[1][0], flipped.triangles[1][1]);
  EXPECT_EQ(mesh_quality(flipped).flipped_edges, 2);
  EXPECT_TRUE(says(warnings(mesh_quality(flipped)), "2 edges lie between triangles that disagree"));
  auto crowded = good;
  crowded.points.conservativeResize(30);
  crowded.points.tail<3>() << 1, 1, 0.5;
  crowded.triangles.push_back({1, 4, 9});
  EXPECT_EQ(mesh_quality(crowded).crowded_edges, 1);
  EXPECT_TRUE(says(warnings(mesh_quality(crowded)), "1 edge belongs to more than two triangles"));
  auto const flat = mesh_quality(single(0, 0, 1, 1, 3, 3));
  EXPECT_EQ(flat.degenerate, 1);
  EXPECT_TRUE(says(warnings(flat), "1 triangle has no area, the first being triangle 0 at"));
  auto const obtuse = mesh_quality(single(0, 0, 2, 0, 1, 0.1));
  EXPECT_TRUE(says(warnings(obtuse), "the largest angle is 168.6 degrees, above 150"));
  EXPECT_TRUE(warnings(mesh_quality(good)).empty());
}

TEST(MeshQuality, finds_a_seam_that_is_not_sewn)
{
  auto left = strip_mesh({0, 1, 2}, {0, 1, 2});
  auto const right = strip_mesh({2, 3, 4}, {0, 1, 2});
  for (auto const& t : right.triangles) left.triangles.push_back({t[0] + 9, t[1] + 9, t[2] + 9});
  left.points.conservativeResize(54);
  left.points.tail<27>() = right.points;
  auto const q = mesh_quality(left);
  EXPECT_EQ(q.slit_points, 6);
  EXPECT_TRUE(says(warnings(q), "6 points of the rim lie in the place of another"));
}

TEST(MeshQuality, needs_a_triangle) { EXPECT_THROW(mesh_quality({}), core::InputError); }

/// Order of the stable step in the smallest height.
template <class Thin>
double order_of_step(Thin const& mesh_of)
{
  std::vector<double> heights, steps;
  for (double const thin : {0.04, 0.02, 0.01}) {
    auto const mesh = mesh_of(thin);
    Sheet const s = make_sheet(mesh, 1e-3, {.c10 = 1e6}, 1000);
    heights.push_back(mesh_quality(mesh).smallest_height.value);
    steps.push_back(stable_step(s, lumped_mass(s), s.reference));
  }
  return tests::order(heights, steps);
}

/// The sentence about small angles says so.
TEST(MeshQuality, stable_step_falls_with_the_smallest_height)
{
  auto const row = [](double thin) { return strip_mesh({0, 1, 2, 2 + thin}, graded(0, 4, 4)); };
  auto const alone = [](double thin) {
    auto mesh = disc_mesh(graded(0, 1, 5));
    mesh.points[1] = 0.2 * (1 - thin);  // the centre comes near a point of the first ring
    return mesh;
  };
  EXPECT_NEAR(order_of_step(row), 1, 0.05);
  EXPECT_NEAR(order_of_step(alone), 0.5, 0.05);
}

}  // namespace
}  // namespace velum::structure
