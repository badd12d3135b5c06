#include "core/geometry/mesh_distance.hpp"
#include "core/obstacle.hpp"
#include "tests/core/stl_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace velum::tests {
namespace {

using namespace core;

class Random {
 public:
  double operator()(double lo, double hi) { return lo + (hi - lo) * share_(generator_); }
  Vec3 in_box(double lo, double hi) { return {(*this)(lo, hi), (*this)(lo, hi), (*this)(lo, hi)}; }

 private:
  std::mt19937_64 generator_{20240501};
  std::uniform_real_distribution<double> share_{0, 1};
};

/// A point beside a corner, an edge or a face of one of the facets, 1e-9 to 0.1 away.
Vec3 beside(Facets const& facets, Random& random)
{
  auto const& f = facets[static_cast<std::size_t>(random(0, double(facets.size())))];
  double const kind = random(0, 3);
  double const s = kind < 1 ? 0 : random(0, 1), t = kind < 2 ? 0 : random(0, 1 - s);
  Vec3 const at = f[0] + s * (f[1] - f[0]) + t * (f[2] - f[0]);
  return at + std::pow(10, random(-9, -1)) * random.in_box(-1, 1);
}

/// Problem:   distance from a mesh whose solid is known by a formula.
/// Reference: the formula.
/// Measure:   largest difference, over 10^4 points of a box around it and 10^4 points 1e-9 to 0.1
///            beside corners, edges and faces, where a wrong normal shows as a wrong sign.
/// Tolerance: 1e-14; a sign can be wrong only nearer to the surface than that.
/// Why:       round-off of lengths of order 1.
template <class Exact>
void expect_exact(Facets const& facets, Exact const& exact)
{
  auto const distance = mesh_distance(merge(facets));
  Random random;
  for (int k = 0; k < 20000; ++k) {
    Vec3 const p = k % 2 == 0 ? random.in_box(-1.5, 1.5) : beside(facets, random);
    ASSERT_NEAR(distance(p), exact(p), 1e-14) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
}

auto const cube = cuboid({-1, -1, -1}, {1, 1, 1});
auto const exact_cube = box<3>({-1, -1, -1}, {1, 1, 1});

/// A star of five points: acute corners, and concave ones between them.
std::vector<Vec2> star()
{
  std::vector<Vec2> corners;
  for (int k = 0; k < 10; ++k) {
    double const radius = k % 2 == 0 ? 1.0 : 0.2, angle = 0.1 + 0.6283185307179586 * k;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}

/// Distance from the prism over an outline: inside the least of the depths, outside Pythagoras.
double prism_distance(Obstacle const& outline, Vec3 const& p)
{
  double const across = distance(outline, {p[0], p[1]}), along = std::abs(p[2]) - 0.5;
  return across <= 0 || along <= 0 ? std::max(across, along) : std::hypot(across, along);
}

TEST(MeshDistance, of_a_cube_is_that_of_the_box) { expect_exact(cube, exact_cube); }

TEST(MeshDistance, of_a_star_with_acute_and_concave_corners_is_exact)
{
  auto const outline = polygon(star());
  expect_exact(prism(star(), {0, 0}, -0.5, 0.5),
               [&](Vec3 const& p) { return prism_distance(outline, p); });
}

TEST(MeshDistance, of_a_solid_with_a_cavity_is_exact)
{
  auto const cavity = box<3>({-0.6, -0.5, -0.4}, {0.5, 0.6, 0.7});
  expect_exact(cube + turned(cuboid({-0.6, -0.5, -0.4}, {0.5, 0.6, 0.7})),
               subtract(exact_cube, cavity));
}

TEST(MeshDistance, does_not_depend_on_the_direction_of_normals)
{
  expect_exact(turned(cube), exact_cube);
  auto one_turned = cube;
  one_turned[5] = turned(one_turned[5]);
  expect_exact(one_turned, exact_cube);
}

TEST(MeshDistance, sign_survives_a_needle_between_two_faces)
{
  // One edge of the cube halved on one side only, the slit closed by a triangle without area.
  Vec3 const a{-1, -1, 1}, b{1, -1, 1}, middle{0, -1, 1}, c{1, 1, 1};
  Facets facets;
  for (auto const& f : cube) {
    bool const halved = norm(f[0] - a) + norm(f[1] - b) + norm(f[2] - c) == 0;
    facets = facets + (halved ? Facets{{a, middle, c}, {middle, b, c}, {a, b, middle}} : Facets{f});
  }
  ASSERT_EQ(facets.size(), 14u);
  expect_exact(facets, exact_cube);
}

/// Problem:   a cube of 200 triangles a side of which one is missing.
/// Reference: the whole cube.
/// Measure:   sign at 10^4 points farther than a fifth of the side from the hole.
/// Tolerance: none wrong.
/// Why:       seen from there the hole takes less than 1/70 of all directions, and four of seven
///            rays would have to leave by it.
TEST(MeshDistance, sign_of_an_open_surface_is_right_away_from_the_hole)
{
  Facets facets;
  for (auto const& [a, b, c] : cube)
    for (int i = 0; i < 10; ++i)
      for (int j = 0; i + j < 10; ++j) {
        Vec3 const u = 0.1 * (b - a), v = 0.1 * (c - a), o = a + double(i) * u + double(j) * v;
        facets.push_back({o, o + u, o + v});
        if (i + j < 9) facets.push_back({o + u, o + u + v, o + v});
      }
  Vec3 const hole = facets[77][0];
  facets.erase(facets.begin() + 77);
  auto const distance = mesh_distance(merge(facets));
  Random random;
  for (int k = 0; k < 10000; ++k) {
    Vec3 const p = random.in_box(-1.5, 1.5);
    if (norm(p - hole) < 0.4) continue;
    ASSERT_EQ(distance(p) < 0, exact_cube(p) < 0) << p[0] << ' ' << p[1] << ' ' << p[2];
  }
}

/// Problem:   distance from a ball of 8192 triangles of radius 1.
/// Reference: |p| - 1.
/// Measure:   error at 10^4 points.
/// Tolerance: from zero to the height of the arc over the flattest triangle.
/// Why:       the corners are on the sphere, so the mesh lies between it and the smaller one that
///            all triangles' planes touch or leave inside.
TEST(MeshDistance, of_a_ball_is_off_by_no_more_than_its_triangles_are)
{
  auto const facets = ball({0, 0, 0}, 1, 5);
  double sagitta = 0;
  for (auto const& f : facets) {
    Vec3 const n = area_vector(f);
    sagitta = std::max(sagitta, 1 - dot(f[0], n) / norm(n));
  }
  EXPECT_LT(sagitta, 1.5e-3);
  auto const distance = mesh_distance(merge(facets));
  Random random;
  for (int k = 0; k < 10000; ++k) {
    Vec3 const p = random.in_box(-1.5, 1.5);
    double const error = distance(p) - (norm(p) - 1);
    ASSERT_GE(error, -1e-14);
    ASSERT_LE(error, sagitta + 1e-14);
  }
}

TEST(MeshDistance, equals_the_nearest_of_all_triangles)
{
  auto const facets = ball({0.2, 0, 0}, 0.5, 2) + prism(star(), {0, 0}, 0.7, 0.9);
  auto const distance = mesh_distance(merge(facets));
  Random random;
  for (int k = 0; k < 2000; ++k) {
    Vec3 const p = random.in_box(-1.5, 1.5);
    double nearest = 1e9;
    for (auto const& [a, b, c] : facets)
      nearest = std::min(nearest, norm(p - closest_point({a, b - a, c - a}, p).point));
    ASSERT_EQ(std::abs(distance(p)), nearest);
  }
}

}  // namespace
}  // namespace velum::tests
