#include "core/geometry/stl_report.hpp"
#include "tests/core/stl_files.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace velum::tests {
namespace {

using namespace core;

StlReport report_of(Facets const& facets, double dx = 1e-4) { return report(merge(facets), dx); }

bool warns(StlReport const& report, std::string const& words)
{
  return text(report).find("warning: " + words) != std::string::npos;
}

Facets const cube = cuboid({0, 0, 0}, {2e-3, 2e-3, 2e-3});

TEST(StlReport, area_and_volume_of_a_cube_are_exact)
{
  auto const r = report_of(cube);
  EXPECT_EQ(r.triangles, 12);
  EXPECT_EQ(r.vertices, 8);
  EXPECT_EQ(r.topology.shells, 1);
  EXPECT_TRUE(is_closed(r.topology));
  EXPECT_EQ(r.normals, Normals::outward);
  EXPECT_NEAR(r.area, 24e-6, 1e-20);
  EXPECT_NEAR(r.volume.value(), 8e-9, 1e-23);
  EXPECT_NEAR(r.thinnest.wall->length, 2e-3, 1e-15);
  EXPECT_FALSE(r.thinnest.gap);
  EXPECT_EQ(text(r).find("warning"), std::string::npos) << text(r);
}

/// Problem:   ball of radius 1 whose triangles are quartered twice.
/// Reference: area 4 pi, volume 4 pi / 3.
/// Measure:   ratio of the errors of both before and after.
/// Tolerance: between 3.5 and 4.5.
/// Why:       inscribed triangles are second order in their size; 4 in the limit.
TEST(StlReport, area_and_volume_of_a_ball_are_second_order)
{
  auto const errors = [](int levels) {
    auto const r = report_of(ball({0, 0, 0}, 1, levels));
    return Vec2{4 * std::numbers::pi - r.area, 4 * std::numbers::pi / 3 - *r.volume};
  };
  auto const coarse = errors(3), fine = errors(4);
  for (int k : {0, 1}) {
    EXPECT_GT(coarse[k] / fine[k], 3.5);
    EXPECT_LT(coarse[k] / fine[k], 4.5);
  }
}

TEST(StlReport, hole_and_flipped_triangle_are_counted_by_their_edges)
{
  auto const open = report_of(Facets(cube.begin() + 1, cube.end()));
  EXPECT_EQ(open.topology.open_edges, 3);
  EXPECT_EQ(open.normals, Normals::unknown);
  EXPECT_FALSE(open.volume);
  EXPECT_EQ(open.sign_rule, SignRule::ray_votes);
  EXPECT_TRUE(warns(open, "the surface is not closed"));
  EXPECT_NE(text(open).find("not closed: 3 open edges"), std::string::npos) << text(open);

  auto facets = cube;
  facets[3] = turned(facets[3]);
  auto const flipped = report_of(facets);
  EXPECT_EQ(flipped.topology.open_edges, 0);
  EXPECT_EQ(flipped.topology.flipped_edges, 3);
  EXPECT_EQ(flipped.normals, Normals::mixed);
  EXPECT_TRUE(warns(flipped, "normals do not all point out"));

  // Two cubes that touch along an edge.
  auto const touching = report_of(cube + cuboid({2e-3, 2e-3, 0}, {4e-3, 4e-3, 2e-3}));
  EXPECT_EQ(touching.topology.non_manifold_edges, 1);
}

TEST(StlReport, needle_between_two_halves_of_an_edge_leaves_the_surface_closed)
{
  Vec3 const a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0}, top{0, 0, 2}, middle{1, 0, 0};
  auto const r = report_of(
      {{a, c, b}, {a, middle, top}, {middle, b, top}, {a, b, middle}, {a, top, c}, {b, c, top}});
  EXPECT_EQ(r.degenerate, 1);
  EXPECT_TRUE(is_closed(r.topology));
  EXPECT_NEAR(*r.volume, 4.0 / 3, 1e-15);
}

TEST(StlReport, normals_are_judged_shell_by_shell)
{
  auto const inner = cuboid({0.5e-3, 0.5e-3, 0.5e-3}, {1.5e-3, 1.5e-3, 1.5e-3});
  auto const hollow = report_of(cube + turned(inner));
  EXPECT_EQ(hollow.topology.shells, 2);
  EXPECT_EQ(hollow.normals, Normals::outward);
  EXPECT_NEAR(*hollow.volume, 7e-9, 1e-20);

  auto const cavity_turned = report_of(cube + inner);
  EXPECT_EQ(cavity_turned.normals, Normals::mixed);
  EXPECT_NEAR(*cavity_turned.volume, 7e-9, 1e-20);
  EXPECT_EQ(report_of(turned(cube)).normals, Normals::inward);
  EXPECT_NEAR(*report_of(turned(cube)).volume, 8e-9, 1e-23);

  for (auto const& r : {hollow, cavity_turned}) {
    EXPECT_NEAR(r.thinnest.wall->length, 0.5e-3, 1e-11);
    EXPECT_NEAR(r.thinnest.gap->length, 1e-3, 1e-11);
  }
}

TEST(StlReport, parts_that_overlap_are_told_from_parts_that_touch)
{
  // A rod through two faces of the cube: its four long edges cross both, no edge of the cube the
  // rod.
  auto const through = report_of(cube + cuboid({0.5e-3, 0.6e-3, -1e-3}, {1.2e-3, 1.3e-3, 3e-3}));
  EXPECT_GE(through.crossing_edges, 4);
  EXPECT_TRUE(warns(through, "the surface crosses itself")) << text(through);

  EXPECT_EQ(report_of(cube).crossing_edges, 0);
  EXPECT_EQ(report_of(ball({0, 0, 0}, 1, 3)).crossing_edges, 0);
  EXPECT_EQ(report_of(cube + cuboid({0.5e-3, 0.6e-3, 2e-3}, {1.2e-3, 1.3e-3, 3e-3})).crossing_edges,
            0);
  EXPECT_EQ(
      report_of(cube + turned(cuboid({0.5e-3, 0.5e-3, 0.5e-3}, {1e-3, 1e-3, 1e-3}))).crossing_edges,
      0);
}

TEST(StlReport, thin_plate_reports_its_thickness)
{
  auto const plate = cuboid({0, 0, 0}, {5e-3, 3e-3, 0.15e-3});
  auto const r = report_of(plate);
  EXPECT_NEAR(r.thinnest.wall->length, 0.15e-3, 1e-15);
  EXPECT_NEAR(r.thinnest.wall->middle[2], 0.075e-3, 1e-15);
  EXPECT_TRUE(warns(r, "the thinnest wall has 1.5 cells of 100 um")) << text(r);
  EXPECT_NE(text(r).find("It takes a dx of at most 75 um."), std::string::npos) << text(r);
  EXPECT_FALSE(warns(report_of(plate, 0.05e-3), ""));
}

TEST(StlReport, gap_between_two_boxes_is_found_where_they_overlap_a_little)
{
  // The upper box stands over a corner of the lower one only, far from the centroids of its faces.
  auto const r = report_of(cuboid({0, 0, 0}, {10e-3, 10e-3, 2e-3}) +
                           cuboid({9e-3, 9e-3, 2.12e-3}, {19e-3, 19e-3, 4e-3}));
  EXPECT_EQ(r.topology.shells, 2);
  ASSERT_TRUE(r.thinnest.gap);
  EXPECT_NEAR(r.thinnest.gap->length, 0.12e-3, 1e-10);
  EXPECT_NEAR(r.thinnest.gap->middle[2], 2.06e-3, 1e-10);
  EXPECT_TRUE(warns(r, "the narrowest gap has 1.2 cells of 100 um")) << text(r);

  auto const touching = report_of(cube + cuboid({0, 0, 2e-3}, {1e-3, 1e-3, 4e-3}));
  EXPECT_NEAR(touching.thinnest.gap->length, 0, 1e-12);
}

TEST(StlReport, corner_of_a_wedge_is_no_gap)
{
  // An angle of 90 degrees: its sides meet, and do not look at each other.
  auto const r =
      report_of(prism({{0, 0}, {3e-3, 0}, {3e-3, 1e-3}, {1e-3, 1e-3}, {1e-3, 3e-3}, {0, 3e-3}},
                      {0.5e-3, 0.5e-3}, 0, 1e-3));
  EXPECT_TRUE(is_closed(r.topology));
  EXPECT_FALSE(r.thinnest.gap);
  EXPECT_NEAR(r.thinnest.wall->length, 1e-3, 1e-9);
}

TEST(StlReport, reads_as_a_few_lines)
{
  auto const r = report_of(cuboid({0, 0, 0}, {10e-3, 5e-3, 0.4e-3}), 0.1e-3);
  EXPECT_EQ(text(r),
            "surface   12 triangles on 8 vertices in 1 shell\n"
            "          closed, normals point outward; inside and outside by pseudo-normals\n"
            "size      10 x 5 x 0.4 mm, from (0, 0, 0) to (10, 5, 0.4) mm\n"
            "          area 112 mm2, volume 20 mm3\n"
            "wall      thinnest 400 um = 4 cells, at (5.365, 1.172, 0.2) mm\n"
            "gap       narrowest none found\n");
}

}  // namespace
}  // namespace velum::tests
