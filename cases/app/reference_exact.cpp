#include <cmath>
#include <numbers>

#include "cases/app/initial_state.hpp"
#include "cases/app/reference.hpp"

namespace velum::cases {
namespace {

/// Sums over the cells with weights.
struct Deviation {
  double squared = 0, whole = 0, worst = 0;

  void add(double weight, Vec3 const& is, Vec3 const& should)
  {
    Vec3 const off = is - should;
    squared += weight * core::dot(off, off);
    whole += weight * core::dot(should, should);
    worst = std::max(worst, core::norm(off));
  }
  double relative() const { return std::sqrt(squared / whole); }
};

template <class Visit>
void each_fluid_cell(Result const& r, Visit const& visit)
{
  auto const& grid = r.flow.grid;
  for (int row = 0; row < grid.nz * grid.ny; ++row)
    for (int i = 0; i < grid.nx; ++i) {
      int const j = row % grid.ny, k = row / grid.ny;
      if (r.flow.walls.is_solid(i, j, k)) continue;
      auto const& c = r.flow.cells(row, i);
      visit(core::position(grid, i, j, k),
            core::to_si_velocity(r.units, 1) * Vec3{c.ux, c.uy, c.uz});
    }
}

}  // namespace

std::vector<core::Figure> compare_taylor_green(Result const& r)
{
  Deviation deviation;
  double along = 0, start = 0;  // projections on the initial flow
  each_fluid_cell(r, [&](Vec3 const& p, Vec3 const& u) {
    auto const first = initial_flow(r.scene, p).velocity;
    deviation.add(1, u, initial_flow(r.scene, p, r.time).velocity);
    along += core::dot(u, first);
    start += core::dot(first, first);
  });
  auto const& lattice = r.scene.lattice;
  double rate = 0;
  for (int axis = 0; axis < 2; ++axis)
    rate += std::pow(2 * std::numbers::pi / (lattice.to[axis] - lattice.from[axis]), 2);
  double const viscosity = r.time > 0 && along > 0 ? std::log(start / along) / (rate * r.time) : 0;
  double const amplitude =
      r.scene.initial.velocity * std::exp(-r.scene.fluid.viscosity * rate * r.time);
  return {{"error_l2", deviation.relative(), "1"},
          {"error_max", deviation.worst / amplitude, "1"},
          {"viscosity_error", std::abs(viscosity / r.scene.fluid.viscosity - 1), "1"}};
}

std::vector<core::Figure> compare_pipe(Result const& r)
{
  double const R = r.scene.reference->length;
  double const top = r.scene.fluid.body_force[0] * R * R / (4 * r.scene.fluid.viscosity);
  bool const space = dimensions(r.scene) == 3;
  Deviation deviation;
  each_fluid_cell(r, [&](Vec3 const& p, Vec3 const& u) {
    double const s = std::hypot(p[1], p[2]) / R;
    // a ring of the meridional plane stands for the more area the farther out it is
    if (s < 1) deviation.add(space ? 1 : s, u, {top * (1 - s * s), 0, 0});
  });
  return {{"error_l2", deviation.relative(), "1"},
          {"error_max", deviation.worst / std::abs(top), "1"},
          {"reynolds", std::abs(top) * R / r.scene.fluid.viscosity, "1"}};
}

}  // namespace velum::cases
