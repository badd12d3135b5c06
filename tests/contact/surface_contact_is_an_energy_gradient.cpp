// problem:   a point over the face, an edge and a corner of a triangle, above and below; two waved
//            sheets of different triangles pressed into each other, by penalty and with multipliers
// reference: central differences of the distance and of the energy; Newton's third law
// measure:   gradient and second derivative of the signed distance; forces and tangent of all
//            contacts; sum and moment of the forces
// tolerance: 1e-8 and 1e-6 of the largest entry; 1e-7 and 1e-5; 1e-14 of the sum of their sizes
// why:       second-order differences over 1e-5 of lengths of order 1 leave 1e-10 of the gradient
//            and, twice, round-off of 1e-7; the sheets' contacts are a thickness of 0.1 wide, which
//            costs two digits; forces balance by construction, to round-off
#include <gtest/gtest.h>

#include <cmath>

#include "contact/surface_contact.hpp"
#include "ibm/sheet_contact.hpp"
#include "ibm/sheet_to_sheet.hpp"
#include "structure/merge_sheets.hpp"
#include "structure/sheet_mesh.hpp"

namespace velum::tests {
namespace {

using core::Vec3;
using Places = std::vector<Vec3>;

double component(Places const& p, std::size_t i) { return p[i / 3][static_cast<int>(i % 3)]; }
Places moved(Places p, std::size_t i, double by)
{
  p[i / 3][static_cast<int>(i % 3)] += by;
  return p;
}

/// Signed distance of the first place from the triangle of the other three.
contact::SignedHeight height(Places const& p)
{
  core::Facet const corners{p[1], p[2], p[3]};
  Vec3 const along = core::area_vector(corners), n = 1 / norm(along) * along;
  return contact::signed_height(contact::foot(corners, p[0], {n, n, n}), 1);
}

std::array<double, 12> gradient(Places const& p)
{
  core::Facet const corners{p[1], p[2], p[3]};
  Vec3 const along = core::area_vector(corners), n = 1 / norm(along) * along;
  auto const f = contact::foot(corners, p[0], {n, n, n});
  auto const N = contact::signed_height(f, 1).normal;
  std::array<double, 12> g;
  for (std::size_t i = 0; i < 12; ++i)
    g[i] = (i < 3 ? 1 : -f.weight[i / 3 - 1]) * N[static_cast<int>(i % 3)];
  return g;
}

TEST(TriangleDistance, has_exact_derivatives_over_face_edges_and_corners)
{
  Places const corners{{0, 0, 0}, {1.1, 0.2, -0.1}, {0.3, 0.9, 0.2}};
  double const step = 1e-5;
  for (Vec3 const x :
       {Vec3{0.4, 0.3, 0.3}, Vec3{0.4, 0.3, -0.4}, Vec3{0.6, -0.1, 0.4}, Vec3{1.0, 0.8, -0.5},
        Vec3{-0.1, 0.5, 0.6}, Vec3{-0.2, -0.1, 0.5}, Vec3{1.4, 0.2, -0.9}, Vec3{0.3, 1.2, 0.9}}) {
    Places const p{x, corners[0], corners[1], corners[2]};
    core::Facet const c{p[1], p[2], p[3]};
    Vec3 const along = core::area_vector(c), n = 1 / norm(along) * along;
    auto const f = contact::foot(c, x, {n, n, n});
    auto const H = contact::second_derivative(c, f, contact::signed_height(f, 1));
    auto const g = gradient(p);
    for (std::size_t j = 0; j < 12; ++j) {
      auto const plus = moved(p, j, step), minus = moved(p, j, -step);
      EXPECT_NEAR((height(plus).distance - height(minus).distance) / (2 * step), g[j], 1e-8);
      auto const ahead = gradient(plus), behind = gradient(minus);
      for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR((ahead[i] - behind[i]) / (2 * step), H[i][j], 1e-6) << i << " " << j;
        EXPECT_NEAR(H[i][j], H[j][i], 1e-13);
      }
    }
  }
}

/// Two waved sheets, the second half as fine, 0.08 apart with a thickness of 0.1.
structure::Sheet pressed_waves()
{
  auto const waved = [](int n, double x) {
    auto mesh = structure::strip_mesh(structure::graded(0, 1, n), structure::graded(0, 1, n));
    for (int a = 0; a < mesh.points.size() / 3; ++a)
      mesh.points[3 * a] =
          x + 0.05 * std::sin(7 * mesh.points[3 * a + 1] + 3 * mesh.points[3 * a + 2]);
    return structure::make_sheet(mesh, 0.1, structure::neo_hookean_rubber(1), 1);
  };
  return structure::merge_sheets(waved(5, 0), waved(7, 0.08));
}

TEST(SurfaceContact, is_the_gradient_of_its_energy_and_has_an_exact_tangent)
{
  auto const s = pressed_waves();
  Places p = ibm::node_places(s.position);
  for (double const multiplier : {0.0, 0.5}) {
    auto c =
        std::make_shared<contact::SurfaceContact>(ibm::make_sheet_to_sheet(s, 20, {.per_side = 2}));
    for (auto& n : c->list.near) n.multiplier = multiplier;
    auto const load = ibm::contact_load(c);
    auto const force = [&](Places const& at, structure::Triplets* tangent) {
      Eigen::VectorXd x(s.position.size()), f = Eigen::VectorXd::Zero(s.position.size());
      for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = component(at, std::size_t(i));
      load(x, f, tangent);
      return f;
    };
    structure::Triplets entries;
    Eigen::VectorXd const f = force(p, &entries);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(f.size(), f.size());
    for (auto const& t : entries) K(t.row(), t.col()) += t.value();
    double const largest = f.cwiseAbs().maxCoeff(), stiffest = K.cwiseAbs().maxCoeff();
    ASSERT_GT(largest, 0);
    double const step = 1e-6;
    for (std::size_t j = 0; j < std::size_t(f.size()); ++j) {
      auto const plus = moved(p, j, step), minus = moved(p, j, -step);
      double const rise = sum_up(*c, plus).energy - sum_up(*c, minus).energy;
      EXPECT_NEAR(f[Eigen::Index(j)], -rise / (2 * step), 1e-7 * largest) << j;
      Eigen::VectorXd const slope = (force(plus, nullptr) - force(minus, nullptr)) / (2 * step);
      EXPECT_LT((slope - K.col(Eigen::Index(j))).cwiseAbs().maxCoeff(), 1e-5 * stiffest) << j;
    }
  }
}

TEST(SurfaceContact, has_neither_resultant_nor_moment)
{
  auto const s = pressed_waves();
  auto const p = ibm::node_places(s.position);
  auto const c = ibm::make_sheet_to_sheet(s, 20, {.per_side = 2});
  Vec3 sum, moment;
  double size = 0;
  for (auto const& t : contact::touches(c, p)) {
    auto const f = contact::force(c, t);
    for (std::size_t a = 0; a < 6; ++a) {
      sum += f.force[a];
      moment += cross(p[std::size_t(f.node[a])], f.force[a]);
      size += norm(f.force[a]);
    }
  }
  ASSERT_GT(size, 0);
  EXPECT_LT(norm(sum), 1e-14 * size);
  EXPECT_LT(norm(moment), 1e-14 * size);
}

}  // namespace
}  // namespace velum::tests
