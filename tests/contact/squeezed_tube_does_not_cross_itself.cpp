// problem:   a tube of 10 mm across and 1 mm thick, 40 elements around, squeezed by two rigid
// plates
//            that close at 2 m/s to three thicknesses, with bending, explicit steps as the program
//            says; the same with next to no contact stiffness
// reference: a solid does not go through itself
// measure:   edges of triangles that go through other triangles, every 50 steps; the largest
//            penetration of the tube into itself at any step; share of its area that touches
// tolerance: none; a fifth of the thickness, against more than the whole without contact (the
// middle
//            surfaces have then passed each other); a tenth touches
// why:       the folds strike hardest: walls that meet at 2 x 2 m/s flat go 2 v sqrt(rho H / k) =
//            0.06 H in, folds 0.16 H were seen
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/geometry/self_crossing.hpp"
#include "ibm/contact_step.hpp"
#include "ibm/sheet_contact.hpp"
#include "ibm/sheet_to_sheet.hpp"
#include "structure/explicit_step.hpp"
#include "structure/sheet_bending.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"

namespace velum::tests {
namespace {

constexpr double R = 5e-3, H = 1e-3, density = 1140, k = 5e9;

int crossings(structure::Sheet const& s)
{
  core::TriangleMesh const mesh{ibm::node_places(s.position), s.triangles, {}, 0};
  return core::crossing_edges(mesh, core::make_tree(mesh));
}

struct Squeeze {
  int crossings = 0;       // the most edges through triangles at any time
  double penetration = 0;  // the largest, of the tube into itself
  double touching = 0;     // share of its area, the largest
};

/// Tube between two plates that close at 2 m/s to three thicknesses, and rest for half a ms.
Squeeze squeeze(double stiffness)
{
  auto s = structure::make_sheet(structure::tube_mesh(R, structure::graded(0, 2.4e-3, 3), 40), H,
                                 structure::neo_hookean_rubber(1e6), density);
  double half_way = R + H;
  auto const plates = std::make_shared<contact::PointContact>(ibm::make_sheet_contact(
      s, [&half_way](core::Vec3 const& X) { return half_way - std::abs(X[2]); }, k));
  auto const self = std::make_shared<contact::SurfaceContact>(
      ibm::make_sheet_to_sheet(s, stiffness, {.per_side = 1}));
  auto const bending = structure::sheet_bending(s, structure::Rim::hinged);
  std::array const loads{structure::bending_load(bending), ibm::contact_load(plates),
                         ibm::contact_load(self)};
  Eigen::VectorXd const mass = structure::lumped_mass(s);
  auto stepper = structure::explicit_stepper(s, {.alpha = 500, .beta = 0});
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(s.position.size());
  Squeeze r;
  double dt = 0;
  int steps = 0;
  for (double time = 0; time < 2.75e-3; time += dt, ++steps) {
    if (steps % 10 == 0) dt = ibm::contact_step(s, mass, *self, std::span(loads).first(1));
    half_way = std::max(1.5 * H, R + H - 2 * time);
    structure::advance(stepper, s, none, {}, dt, 1, loads);
    follow(*self, ibm::node_places(s.position));
    if (steps % 50 == 0) r.crossings = std::max(r.crossings, crossings(s));
    auto const sum = sum_up(*self, ibm::node_places(s.position));
    r.penetration = std::max(r.penetration, sum.penetration);
    r.touching = std::max(r.touching, sum.area / structure::nodal_area(s).sum());
  }
  return r;
}

TEST(SqueezedTube, does_not_cross_itself)
{
  auto const r = squeeze(k);
  EXPECT_EQ(r.crossings, 0);
  EXPECT_LT(r.penetration, 0.2 * H);
  EXPECT_GT(r.touching, 0.1);
  EXPECT_GT(squeeze(1e-3).penetration, H);
}

}  // namespace
}  // namespace velum::tests
