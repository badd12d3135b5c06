#include "core/geometry/mesh_distance.hpp"
#include "core/geometry/solid_cells.hpp"
#include "tests/core/scratch.hpp"
#include "tests/core/stl_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velum::tests {
namespace {

using namespace core;

/// Area on the left of a closed line.
double area_of(Polyline const& line)
{
  double twice = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    twice += line[k][0] * line[k + 1][1] - line[k][1] * line[k + 1][0];
  return twice / 2;
}

bool is_closed_line(Polyline const& line) { return norm(line.front() - line.back()) == 0; }

TEST(MeshSection, of_a_box_is_its_rectangle_with_the_solid_on_the_left)
{
  auto const mesh = merge(cuboid({0, 0, 0}, {1, 2, 4}));
  double const expected[3] = {8, 4, 2};
  for (int axis : {0, 1, 2}) {
    auto const lines = section(mesh, {axis, 0.3});
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(is_closed_line(lines[0]));
    EXPECT_NEAR(area_of(lines[0]), expected[axis], 1e-14);
  }
  EXPECT_TRUE(section(mesh, {0, 1.5}).empty());
}

TEST(MeshSection, in_the_plane_of_a_face_or_of_corners_is_drawn_once_or_not_at_all)
{
  auto const box = merge(cuboid({0, 0, 0}, {1, 2, 4}));
  EXPECT_TRUE(section(box, {2, 0}).empty());  // the face looks down, all solid is above
  ASSERT_EQ(section(box, {2, 4}).size(), 1u);
  EXPECT_NEAR(area_of(section(box, {2, 4})[0]), 2, 1e-14);

  auto const lines = section(merge(ball({0, 0, 0}, 1, 3)), {1, 0});  // through many corners
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(is_closed_line(lines[0]));
  EXPECT_NEAR(area_of(lines[0]), 16 * std::sin(2 * std::acos(-1.0) / 32), 1e-12);  // a 32-gon
}

TEST(MeshSection, of_a_hollow_solid_has_a_line_around_the_solid_and_one_around_the_hole)
{
  auto const lines =
      section(merge(cuboid({0, 0, 0}, {3, 3, 3}) + turned(cuboid({1, 1, 1}, {2, 2, 2}))), {2, 1.5});
  ASSERT_EQ(lines.size(), 2u);
  double const a = area_of(lines[0]), b = area_of(lines[1]);
  EXPECT_NEAR(std::max(a, b), 9, 1e-14);
  EXPECT_NEAR(std::min(a, b), -1, 1e-14);
}

TEST(MeshSection, of_an_open_surface_is_one_open_line)
{
  auto facets = cuboid({0, 0, 0}, {1, 1, 1});
  facets.erase(facets.begin() + 4);
  auto const lines = section(merge(facets), {2, 0.3});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(is_closed_line(lines[0]));
}

TEST(MeshSection, solid_cells_are_those_whose_centre_is_solid)
{
  auto const mesh = merge(cuboid({0, 0, 0}, {1, 0.96, 0.52}));
  auto const runs = solid_cells(mesh_distance(mesh), bounds(mesh), {0, 0.5}, 0.1);
  ASSERT_EQ(runs.size(), 5u);  // rows of z; the sixth has its centre at 0.55, in the fluid
  for (auto const& [lo, hi] : runs) {
    EXPECT_NEAR(lo[0], 0, 1e-15);
    EXPECT_NEAR(hi[0], 1.0, 1e-15);  // the tenth centre, 0.95, is solid
  }
  EXPECT_NEAR(runs[4].hi[1], 0.5, 1e-15);
}

TEST(MeshSection, is_written_as_a_table_of_points)
{
  Scratch const scratch("section");
  auto const file = scratch.folder / "section.csv";
  write_section(file, {{{0, 1}, {0.5, 1}}, {{2, 3}}}, {1, 0});
  EXPECT_EQ(text_of(file), "line [1],z [m],x [m]\n0,0,1\n0,0.5,1\n1,2,3\n");
  write_cells(file, {{{0, 1}, {0.5, 2}}}, {1, 0});
  EXPECT_EQ(text_of(file), "z from [m],z to [m],x from [m],x to [m]\n0,0.5,1,2\n");
}

}  // namespace
}  // namespace velum::tests
