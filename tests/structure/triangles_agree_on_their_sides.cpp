// problem:   surfaces some of whose triangles are turned over; surfaces without two sides
// reference: the surface as made; Moebius's strip of any number of sectors has one side, the same
//            strip without the twist has two
// measure:   triangles, how many were turned, the sentence
// tolerance: none
// why:       sides are combinatorial: nothing is rounded
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/check.hpp"
#include "structure/mesh_neighbours.hpp"
#include "structure/sheet_mesh.hpp"

namespace velum::structure {
namespace {

std::string refusal(TriangleMesh mesh)
{
  try {
    agree_on_sides(mesh);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

/// A band of two rows of points round a circle, closed with half a turn or without one.
TriangleMesh band(int sectors, bool twisted)
{
  TriangleMesh mesh{Eigen::VectorXd(6 * sectors), {}};
  for (int i = 0; i < sectors; ++i)
    for (int side : {0, 1}) {
      double const angle = 2 * std::numbers::pi * i / sectors, tilt = twisted ? angle / 2 : 0;
      double const across = side ? 0.2 : -0.2, radius = 1 + across * std::cos(tilt);
      mesh.points.segment<3>(3 * (2 * i + side)) << radius * std::cos(angle),
          radius * std::sin(angle), across * std::sin(tilt);
    }
  for (int i = 0; i < sectors; ++i) {
    bool const crosses = twisted && i + 1 == sectors;
    int const a = 2 * i, b = a + 1, next = 2 * ((i + 1) % sectors);
    int const c = next + crosses, d = next + !crosses;
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({b, c, d});
  }
  return mesh;
}

TEST(Sides, are_mended_where_triangles_are_turned_over)
{
  std::mt19937 engine{11};
  std::bernoulli_distribution coin(0.4);
  for (auto const& whole : {disc_mesh(graded(0, 1, 6)), tube_mesh(1, {0, 1, 2, 3}, 8)}) {
    auto mesh = whole;
    int turned = 0;
    for (std::size_t t = 1; t < mesh.triangles.size(); ++t)
      if (coin(engine)) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]), ++turned;
    EXPECT_EQ(agree_on_sides(mesh), turned);
    EXPECT_EQ(mesh.triangles, whole.triangles);
    EXPECT_EQ(agree_on_sides(mesh), 0);
  }
}

TEST(Sides, follow_the_first_triangle_of_each_part)
{
  auto mesh = strip_mesh({0, 1, 2}, {0, 1, 2});
  auto const one = mesh.triangles;
  for (auto t : one) mesh.triangles.push_back({t[0] + 9, t[2] + 9, t[1] + 9});
  mesh.points = mesh.points.replicate(2, 1).eval();
  std::swap(mesh.triangles[10][1], mesh.triangles[10][2]);
  EXPECT_EQ(agree_on_sides(mesh), 1);
  for (std::size_t t = 0; t < one.size(); ++t)
    EXPECT_EQ(mesh.triangles[8 + t], (Triangle{one[t][0] + 9, one[t][2] + 9, one[t][1] + 9}));
}

TEST(Sides, there_are_two_of_a_band_and_one_of_moebius_strip)
{
  for (int const sectors : {5, 12, 31}) {
    EXPECT_EQ(refusal(band(sectors, false)), "");
    EXPECT_NE(refusal(band(sectors, true)).find("has one side only, as Moebius's strip has"),
              std::string::npos);
  }
}

TEST(Sides, are_refused_where_surfaces_branch)
{
  auto mesh = strip_mesh({0, 1, 2}, {0, 1, 2});
  mesh.points.conservativeResize(30);
  mesh.points.tail<3>() << 1, 1, 0.5;
  mesh.triangles.push_back({1, 4, 9});  // on the edge from (0, 0, 1) to (0, 1, 1)
  EXPECT_EQ(refusal(mesh),
            "An edge of the mesh at (0, 0.5, 1) m belongs to more than two triangles, and a sheet "
            "has two sides everywhere: take away what branches off there.");
}

TEST(Sides, need_triangles_of_three_points_of_the_mesh)
{
  auto mesh = strip_mesh({0, 1}, {0, 1});
  mesh.triangles[1] = {0, 3, 3};
  EXPECT_EQ(refusal(mesh), "Triangle 1 of a mesh has a corner twice.");
  mesh.triangles[1] = {0, 3, 4};
  EXPECT_EQ(refusal(mesh), "Triangle 1 of a mesh has the corner 4, but the mesh has 4 points.");
}

}  // namespace
}  // namespace velum::structure
