// problem:    faces of a membrane blown from a flat disc to part of a sphere, and to x = cos(2 y)
// reference:  sphere: normal = radius vector; curve: normal (1, 2 sin(2 y)) / length
// measure:    largest error of the normals inside the chain; normal on the axis
// tolerance:  sphere 1e-13, uneven nodes too; curve order 2 +- 0.1
// why:        weights by the other element's length make the mean tangent of two chords of a circle
//             exact; on a general curve it is that of the parabola, second order
#include "structure/faces.hpp"
#include "structure/membrane.hpp"
#include "tests/support/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace velum::structure {
namespace {

Membrane disc(int elements, double thickness)
{
  return flat_membrane({core::Symmetry::axisymmetric, 0, 1, 1.0 / elements,
                        [=](double) { return thickness; }, neo_hookean_rubber(1), 1});
}

TEST(Faces, of_a_sphere_are_exact)
{
  auto m = disc(20, 0.1);
  for (int a = 0; a < node_count(m); ++a) {
    double const y = m.reference[2 * a + 1], angle = y + 0.2 * y * y;
    m.position[2 * a] = std::cos(angle);
    m.position[2 * a + 1] = std::sin(angle);
  }
  Faces faces;
  locate_faces(m, m.position, 1, faces);
  EXPECT_EQ(faces.normal[0][0], 1);
  EXPECT_EQ(faces.normal[0][1], 0);
  for (int a = 1; a + 1 < node_count(m); ++a) {
    EXPECT_LT(norm(faces.normal[a] - node(m.position, a)), 1e-13);
    EXPECT_NEAR(norm(faces.plus[a]), 1 + 0.5 * faces.thickness[a], 1e-13);
    EXPECT_NEAR(norm(faces.minus[a]), 1 - 0.5 * faces.thickness[a], 1e-13);
  }
}

double normal_error(int elements)
{
  auto m = disc(elements, 0.1);
  for (int a = 0; a < node_count(m); ++a) {
    double const y = m.reference[2 * a + 1];
    m.position[2 * a] = std::cos(2 * y);
  }
  Faces faces;
  locate_faces(m, m.position, 1, faces);
  double worst = 0;
  for (int a = 1; a + 1 < node_count(m); ++a) {
    core::Vec2 const across{1, 2 * std::sin(2 * m.reference[2 * a + 1])};
    worst = std::max(worst, norm(faces.normal[a] - (1 / norm(across)) * across));
  }
  return worst;
}

TEST(Faces, of_a_curve_are_second_order)
{
  std::vector<double> size, error;
  for (int const n : {20, 40, 80}) size.push_back(1.0 / n), error.push_back(normal_error(n));
  EXPECT_NEAR(tests::order(size, error), 2, 0.1);
}

}  // namespace
}  // namespace velum::structure
