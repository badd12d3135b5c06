// problem:   a free membrane of 1/10 of the mass of the fluid in a cell, without tension, in a
//            uniform flow in a box periodic both ways, across it and along it, starting at rest
// reference: momentum is kept: both end with the velocity  M_f u / (M_f + M_s)
// measure:   velocity of every node after 3000 steps; momentum of fluid and membrane together
// tolerance: 1e-3 of u; 1e-11 of the momentum
// why:       markers and fluid approach each other at a rate of order one, vortices that the start
//            leaves beside the ends decay with viscosity; what one side gives the other
//            gets to round-off, for the impulse of the step is that of the mean velocity
#include <gtest/gtest.h>

#include "structure/mass.hpp"
#include "tests/ibm/diffuse_box.hpp"

namespace velum {
namespace {

TEST(DiffuseMembrane, GoesWithAUniformFlow)
{
  constexpr int n = 24;
  constexpr double u = 0.02, h = 2, mass_per_area = 0.1;
  for (core::Vec2 flow : {core::Vec2{u, 0}, core::Vec2{0, u}, core::Vec2{u, u}}) {
    lbm::Model model{lbm::Collision::central_moments, 0.1};
    model.periodic_x = model.periodic_y = true;
    tests::DiffuseScene s;
    s.fluid = lbm::make_fluid<double>(n, n, {0, 0}, core::Symmetry::planar, model);
    lbm::CellStates state("state", n, n);
    Kokkos::deep_copy(state, lbm::CellState{0, flow[0], flow[1]});
    lbm::set_equilibrium(s.fluid, state);
    s.walls = tests::no_solids();
    s.membrane = structure::flat_membrane(
        {core::Symmetry::planar, 0.0, double(n), 1.0, [](double) { return h; },
         structure::neo_hookean_rubber(0.01), mass_per_area / h, 9.3});
    std::fill(s.membrane.fixed.begin(), s.membrane.fixed.end(), 0);
    s.body = ibm::make_diffuse(s.fluid, lbm::find_walls(s.fluid, s.walls), {}, s.membrane, 0);
    s.stepper = structure::explicit_stepper(s.membrane, {});
    for (int t = 0; t < 3000; ++t) ibm::step(s);

    Eigen::VectorXd const nodal_mass = structure::lumped_mass(s.membrane);
    double const fluid_mass = n * n, mass = nodal_mass.sum();
    core::Vec2 const expected = fluid_mass / (fluid_mass + mass) * flow;
    core::Vec2 momentum = {0, 0};
    for (int a = 0; a < structure::node_count(s.membrane); ++a) {
      core::Vec2 const V = structure::node(s.membrane.velocity, a);
      EXPECT_NEAR(V[0], expected[0], 1e-3 * u) << a;
      EXPECT_NEAR(V[1], expected[1], 1e-3 * u) << a;
      momentum += nodal_mass[a] * V;
    }
    auto const cells = lbm::cell_states(s.fluid);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        momentum += (1 + cells(j, i).rho) * core::Vec2{cells(j, i).ux, cells(j, i).uy};
    for (int d : {0, 1}) EXPECT_NEAR(momentum[d], fluid_mass * flow[d], 1e-11 * fluid_mass * u);
  }
}

}  // namespace
}  // namespace velum
