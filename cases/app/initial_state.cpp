#include "cases/app/initial_state.hpp"

#include <cmath>
#include <numbers>

namespace velum::cases {
namespace {

FlowState taylor_green(Scene const& scene, Vec2 const& side, Vec2 const& s, double time)
{
  double const pi2 = 2 * std::numbers::pi, a = pi2 / side[0], b = pi2 / side[1];
  double const U =
      scene.initial.velocity * std::exp(-scene.fluid.viscosity * (a * a + b * b) * time);
  double const x = pi2 * s[0], y = pi2 * s[1];
  return {{-U * std::sqrt(b / a) * std::cos(x) * std::sin(y),
           U * std::sqrt(a / b) * std::sin(x) * std::cos(y)},
          -U * U / 4 * (b / a * std::cos(2 * x) + a / b * std::cos(2 * y))};
}

FlowState shear_layer(InitialState const& initial, Vec2 const& s)
{
  double const k = initial.steepness;
  return {{initial.velocity * std::tanh(k * (s[1] <= 0.5 ? s[1] - 0.25 : 0.75 - s[1])),
           initial.velocity * initial.disturbance * std::sin(2 * std::numbers::pi * (s[0] + 0.25))},
          0};
}

}  // namespace

FlowState initial_flow(Scene const& scene, Vec2 const& p, double time)
{
  auto const& lattice = scene.lattice;
  Vec2 const side = lattice.to - lattice.from;
  Vec2 const s = {(p[0] - lattice.from[0]) / side[0], (p[1] - lattice.from[1]) / side[1]};
  switch (scene.initial.kind) {
    case InitialKind::taylor_green:
      return taylor_green(scene, side, s, time);
    case InitialKind::shear_layer:
      return shear_layer(scene.initial, s);
    case InitialKind::rest:
      break;
  }
  return {};
}

template <class Real>
void set_initial_state(Scene const& scene, LatticeScene<Real>& lattice)
{
  if (scene.initial.kind == InitialKind::rest) return;
  core::Units const& units = lattice.derived.units;
  core::Grid const& grid = lattice.derived.grid;
  lbm::CellStates state("initial_state", grid.ny, grid.nx);
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      auto const flow = initial_flow(scene, core::position(grid, i, j));
      double const p =
          core::to_lattice_pressure(units, scene.fluid.density * flow.kinematic_pressure);
      state(j, i) = {3 * p, core::to_lattice_velocity(units, flow.velocity[0]),
                     core::to_lattice_velocity(units, flow.velocity[1])};
    }
  lbm::set_equilibrium(lattice.fluid, state);
}

template void set_initial_state(Scene const&, LatticeScene<float>&);
template void set_initial_state(Scene const&, LatticeScene<double>&);

}  // namespace velum::cases
