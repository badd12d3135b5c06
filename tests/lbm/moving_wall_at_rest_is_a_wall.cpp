// problem:   a disturbed flow in a closed box with a ball (a disc in the plane) in it; its walls at
//            rest, moving at zero speed along any profile, shared out between both, or openings
//            that let nothing through
// reference: the same flow between walls at rest
// measure:   every population that leaves a cell, after 50 steps, every lattice and precision
// tolerance: none
// why:       the wall's term is a product with the speed, and nothing else of it may differ; the
//            opening's rule is the half-way one, which is what a side of the box has
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flow.hpp"
#include "tests/support/lattices.hpp"

namespace velum {
namespace {

enum class Walls { rest, moving, shared, closed_velocity, closed_flow_rate };

template <class L, class Real, class Stored>
void disturb(lbm::Fluid<Real, L, Stored>& fluid)
{
  lbm::CellStates state("state", fluid.ny * fluid.nz, fluid.nx);
  for (int row = 0; row < fluid.ny * fluid.nz; ++row)
    for (int i = 0; i < fluid.nx; ++i)
      state(row, i) = {0.01 * std::sin(i), 0.02 * (row % 5), 0.03 * std::cos(row + i), -0.01 * i};
  lbm::set_equilibrium(fluid, state);
}

tests::Assign parts(Walls walls)
{
  return [walls](lbm::WallHit const& h) {
    switch (walls) {
      case Walls::rest:
        return -1;
      case Walls::moving:
        return -2;
      case Walls::shared:
        return (h.i + h.j + h.k + h.dir) % 2 ? -1 : -2;
      default:
        return h.box_side ? 0 : -1;
    }
  };
}

template <class F>
std::vector<typename F::Real> marched(Walls walls)
{
  using L = typename F::L;
  int const nx = 9, ny = 10, nz = 8;
  auto fluid = lbm::make_fluid<typename F::Real, L, typename F::Stored>(
      nx, ny, {}, core::Symmetry::planar, {lbm::Collision::central_moments, 0.01}, nz);
  core::Vec<double, L::D> centre;
  for (int a = 0; a < L::D; ++a) centre[a] = 4.1 + 0.2 * a;
  auto const kind =
      walls == Walls::closed_velocity ? lbm::OpeningKind::velocity : lbm::OpeningKind::flow_rate;
  auto flow = tests::make_flow(
      fluid, [&](core::Vec<double, L::D> const& p) { return norm(p - centre) - 1.7; }, parts(walls),
      {{kind, {1, 0, 0}, 0, [](core::Vec3 const& at) { return at[0] + 0.3; }}});
  disturb(flow.fluid);
  for (int t = 0; t < 50; ++t) tests::step(flow);
  std::vector<typename F::Real> all;
  for (long n = 0; n < flow.fluid.cells(); ++n) {
    int const cell = flow.fluid.cell_of(n);
    if (!flow.fluid.active(cell)) continue;
    for (int d = 0; d < L::Q; ++d) all.push_back(flow.fluid.f.outgoing(d, cell));
  }
  return all;
}

TEST(MovingWall, AtZeroSpeedIsAWallAtRest)
{
  tests::with_each_format([](auto format) {
    using F = decltype(format);
    auto const rest = marched<F>(Walls::rest);
    EXPECT_NE(rest[1], 0) << F::name();
    for (auto walls : {Walls::moving, Walls::shared})
      EXPECT_TRUE(marched<F>(walls) == rest) << F::name() << " " << int(walls);
  });
}

TEST(ClosedOpening, IsAWall)
{
  tests::with_each_format([](auto format) {
    using F = decltype(format);
    auto const rest = marched<F>(Walls::rest);
    for (auto walls : {Walls::closed_velocity, Walls::closed_flow_rate})
      EXPECT_TRUE(marched<F>(walls) == rest) << F::name() << " " << int(walls);
  });
}

}  // namespace
}  // namespace velum
