#include "cases/app/initial_state.hpp"

#include "lbm/formats.hpp"
#include "lbm/initial_stress.hpp"

#include <cmath>
#include <numbers>

namespace velum::cases {
namespace {

FlowState taylor_green(Scene const& scene, Vec3 const& side, Vec3 const& s, double time)
{
  double const pi2 = 2 * std::numbers::pi, a = pi2 / side[0], b = pi2 / side[1];
  double const U =
      scene.initial.velocity * std::exp(-scene.fluid.viscosity * (a * a + b * b) * time);
  double const x = pi2 * s[0], y = pi2 * s[1];
  return {{-U * std::sqrt(b / a) * std::cos(x) * std::sin(y),
           U * std::sqrt(a / b) * std::sin(x) * std::cos(y)},
          -U * U / 4 * (b / a * std::cos(2 * x) + a / b * std::cos(2 * y))};
}

FlowState taylor_green_in_space(double U, Vec3 const& s)
{
  double const pi2 = 2 * std::numbers::pi, x = pi2 * s[0], y = pi2 * s[1], z = pi2 * s[2];
  return {{U * std::sin(x) * std::cos(y) * std::cos(z),
           -U * std::cos(x) * std::sin(y) * std::cos(z), 0},
          U * U / 16 * (std::cos(2 * x) + std::cos(2 * y)) * (std::cos(2 * z) + 2)};
}

FlowState shear_layer(InitialState const& initial, Vec3 const& s)
{
  double const k = initial.steepness;
  return {{initial.velocity * std::tanh(k * (s[1] <= 0.5 ? s[1] - 0.25 : 0.75 - s[1])),
           initial.velocity * initial.disturbance * std::sin(2 * std::numbers::pi * (s[0] + 0.25))},
          0};
}

}  // namespace

FlowState initial_flow(Scene const& scene, Vec3 const& p, double time)
{
  auto const& lattice = scene.lattice;
  Vec3 const side = lattice.to - lattice.from;
  Vec3 s;
  for (int a = 0; a < dimensions(scene); ++a) s[a] = (p[a] - lattice.from[a]) / side[a];
  switch (scene.initial.kind) {
    case InitialKind::taylor_green:
      return dimensions(scene) == 3 ? taylor_green_in_space(scene.initial.velocity, s)
                                    : taylor_green(scene, side, s, time);
    case InitialKind::shear_layer:
      return shear_layer(scene.initial, s);
    case InitialKind::uniform:
      return {{scene.initial.velocity, 0, 0}, 0};
    case InitialKind::rest:
      break;
  }
  return {};
}

template <class Real, class L, class Stored>
void set_initial_state(Scene const& scene, LatticeScene<Real, L, Stored>& lattice)
{
  if (scene.initial.kind == InitialKind::rest) return;
  core::Units const& units = lattice.derived.units;
  core::Grid const& grid = lattice.derived.grid;
  lbm::CellStates state("initial_state", grid.nz * grid.ny, grid.nx);
  for (int row = 0; row < grid.nz * grid.ny; ++row)
    for (int i = 0; i < grid.nx; ++i) {
      auto const flow = initial_flow(scene, core::position(grid, i, row % grid.ny, row / grid.ny));
      double const p =
          core::to_lattice_pressure(units, scene.fluid.density * flow.kinematic_pressure);
      state(row, i) = {3 * p, core::to_lattice_velocity(units, flow.velocity[0]),
                       core::to_lattice_velocity(units, flow.velocity[1]),
                       core::to_lattice_velocity(units, flow.velocity[2])};
    }
  lbm::set_equilibrium(lattice.fluid, state);
  lbm::add_viscous_stress(lattice.fluid, state);
}

#define VELUM_INSTANTIATE(Real, L, Stored) \
  template void set_initial_state(Scene const&, LatticeScene<Real, lbm::L, Stored>&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::cases
