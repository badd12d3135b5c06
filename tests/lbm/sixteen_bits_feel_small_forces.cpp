// problem:   a periodic box of fluid at rest in 16-bit storage, under a body force that changes no
//            population by more than a fortieth of a stored unit in a step; planar and in space
// reference: u = F t; mass and the other components stay
// measure:   mean momentum per cell after 1000 steps over F t; mean change of the density
// tolerance: 4 %; 4e-5
// why:       rounded to the nearest, each step would leave every population where it was. Rounded
//            at random a cell's density walks by some 0.4 of the largest unit, 1.7e-5, a step, and
//            a component of its momentum by some 1e-5: after 1000 steps and over 4096 cells by half
//            of these, 5e-6 or 0.5 % of F t in momentum; five and eight of those
#include <gtest/gtest.h>

#include "lbm/formats.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum {
namespace {

template <class L>
void expect_to_be_felt(lbm::Collision collision, int n, int nz, int steps)
{
  constexpr double force = 1e-6;
  lbm::Model const model{.collision = collision,
                         .viscosity = 0.05,
                         .body_force = {force, 0, 0},
                         .periodic_x = true,
                         .periodic_y = true,
                         .periodic_z = true};
  auto fluid = lbm::make_fluid<float, L, std::int16_t>(n, n, {}, core::Symmetry::planar, model, nz);
  for (int t = 0; t < steps; ++t) {
    lbm::fill_ghosts(fluid);
    lbm::stream_and_collide(fluid);
  }
  auto const cells = lbm::cell_states(fluid);
  double mass = 0, u[3] = {};
  for (std::size_t row = 0; row < cells.extent(0); ++row)
    for (std::size_t i = 0; i < cells.extent(1); ++i) {
      auto const& c = cells(row, i);
      mass += c.rho, u[0] += c.ux, u[1] += c.uy, u[2] += c.uz;
    }
  auto const count = double(fluid.cells());
  EXPECT_NEAR(u[0] / count / (force * steps), 1, 0.04);
  EXPECT_NEAR(u[1] / count / (force * steps), 0, 0.04);
  EXPECT_NEAR(u[2] / count / (force * steps), 0, 0.04);
  EXPECT_NEAR(mass / count, 0, 4e-5);
}

TEST(SixteenBits, feel_a_force_of_a_fraction_of_a_unit)
{
  expect_to_be_felt<lbm::D2Q9>(lbm::Collision::central_moments, 64, 1, 1001);
  expect_to_be_felt<lbm::D3Q19>(lbm::Collision::central_moments, 16, 16, 1000);
  expect_to_be_felt<lbm::D3Q27>(lbm::Collision::cumulant, 16, 16, 1000);
}

}  // namespace
}  // namespace velum
