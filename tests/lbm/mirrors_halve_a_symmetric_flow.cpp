// problem:   a ball in a duct, flow across it from a velocity inlet to an outflow, the ball's
//            centre on one side of the box that is a plane of symmetry: across each axis, at its
//            lower and upper end, and across two axes at once. In space, D3Q19 and D3Q27
// reference: the whole flow, without the plane, in the box and its image
// measure:   density and velocity of every cell, force on the walls, mass through the openings
// tolerance: 1e-12 of quantities of 0.01 to 0.1, over 60 steps
// why:       the mirror hands back what its image would have sent, so all that differs is the
//            order of sums, some 1e-16 a step
#include <gtest/gtest.h>

#include <cmath>

#include "lbm/wall_force.hpp"
#include "tests/support/flow.hpp"
#include "tests/support/lattices.hpp"

namespace velum {
namespace {

constexpr double radius = 2.6;

/// Which sides of the box are planes of symmetry, [axis][upper].
struct Planes {
  bool at[3][2] = {};

  unsigned mirrors() const
  {
    unsigned bits = 0;
    for (int a = 0; a < 3; ++a)
      for (bool upper : {false, true})
        if (at[a][upper]) bits |= lbm::mirror(a, upper);
    return bits;
  }
};

struct Result {
  lbm::CellStates state;
  core::Vec3 force;
  double inflow, outflow;
};

/// A box of `size` cells with the flow along an axis; its first state is even about the ball's
/// centre.
template <class L>
Result flow_past_ball(std::array<int, 3> size, int along, unsigned mirrors, core::Vec3 centre)
{
  lbm::Model model{lbm::Collision::central_moments, 0.02};
  model.mirrors = mirrors;
  auto fluid =
      lbm::make_fluid<double, L>(size[0], size[1], {}, core::Symmetry::planar, model, size[2]);
  core::Vec3 normal;
  normal[along] = 1;
  auto const ends = [&](lbm::WallHit const& h) {
    int const at[3] = {h.i, h.j, h.k}, c = L::c(h.dir, along);
    return at[along] == 0 && c < 0 ? 0 : at[along] == size[along] - 1 && c > 0 ? 1 : -1;
  };
  auto flow = tests::make_flow(
      fluid, [&](core::Vec3 const& p) { return norm(p - centre) - radius; }, ends,
      {{lbm::OpeningKind::velocity, normal, 0.03}, {lbm::OpeningKind::outflow, -1.0 * normal, 0}});
  lbm::CellStates state("state", size[1] * size[2], size[0]);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        core::Vec3 const r = core::Vec3{i + 0.5, j + 0.5, k + 0.5} - centre;
        double u[3], even = 0.01 * std::cos(r[0] / 2) * std::cos(r[1] / 3) * std::cos(r[2] / 4);
        for (int a = 0; a < 3; ++a) u[a] = a == along ? 2 * even : even * std::sin(r[a]);
        state(k * size[1] + j, i) = {even, u[0], u[1], u[2]};
      }
  lbm::set_equilibrium(flow.fluid, state);
  for (int t = 0; t < 60; ++t) tests::step(flow);
  lbm::fill_ghosts(flow.fluid);
  auto const force = lbm::wall_force(flow.fluid, flow.resting);
  return {lbm::cell_states(flow.fluid),
          {force[0], force[1], force[2]},
          flow.openings[0].mass_flow,
          flow.openings[1].mass_flow};
}

/// The flow in a box with mirrors against that in the box and its images.
template <class L>
void expect_same_flow(Planes const& planes, int along)
{
  std::array<int, 3> half = {9, 10, 11}, whole, shift = {0, 0, 0};
  core::Vec3 centre = {4.3, 4.6, 5.7}, image;
  double parts = 1;
  whole = half;
  for (int a = 0; a < 3; ++a) {
    image[a] = centre[a];
    if (!planes.at[a][0] && !planes.at[a][1]) continue;
    parts *= 2;
    whole[a] = 2 * half[a];
    shift[a] = planes.at[a][0] ? half[a] : 0;
    centre[a] = planes.at[a][0] ? 0 : half[a];
    image[a] = half[a];
  }
  auto const one = flow_past_ball<L>(half, along, planes.mirrors(), centre);
  auto const all = flow_past_ball<L>(whole, along, 0, image);
  double worst = 0, speed = 0;
  for (int k = 0; k < half[2]; ++k)
    for (int j = 0; j < half[1]; ++j)
      for (int i = 0; i < half[0]; ++i) {
        auto const& a = one.state(k * half[1] + j, i);
        auto const& b = all.state((k + shift[2]) * whole[1] + j + shift[1], i + shift[0]);
        for (double d : {a.rho - b.rho, a.ux - b.ux, a.uy - b.uy, a.uz - b.uz})
          worst = std::max(worst, std::abs(d));
        speed = std::max(speed, std::hypot(a.ux, a.uy, a.uz));
      }
  EXPECT_LT(worst, 1e-12);
  EXPECT_GT(speed, 0.03);
  EXPECT_NEAR(parts * one.force[along], all.force[along], 1e-11);
  EXPECT_NEAR(parts * one.inflow, all.inflow, 1e-11);
  EXPECT_NEAR(parts * one.outflow, all.outflow, 1e-11);
}

template <class L>
void expect_halves_and_quarters()
{
  for (int axis = 0; axis < 3; ++axis)
    for (bool upper : {false, true})
      for (int along : {(axis + 1) % 3, (axis + 2) % 3}) {
        SCOPED_TRACE(testing::Message()
                     << "D3Q" << L::Q << ", mirror across axis " << axis
                     << (upper ? " above" : " below") << ", flow along axis " << along);
        Planes planes;
        planes.at[axis][upper] = true;
        expect_same_flow<L>(planes, along);
        planes.at[3 - axis - along][!upper] = true;
        expect_same_flow<L>(planes, along);
      }
}

TEST(Mirrors, HalveASymmetricFlow)
{
  expect_halves_and_quarters<lbm::D3Q19>();
  expect_halves_and_quarters<lbm::D3Q27>();
}

}  // namespace
}  // namespace velum
