#pragma once
#include <Kokkos_Core.hpp>
#include <cstdint>

#include "core/symmetry.hpp"
#include "core/vec.hpp"

namespace velum::lbm {

enum class Collision { bgk, trt, central_moments };

/// What the fluid is and how it relaxes, lattice units.
struct Model {
  Collision collision = Collision::central_moments;
  double viscosity = 0.1;
  double magic = 1.0 / 8;
  double smagorinsky = 0;          // constant C of nu_t = (C dx)^2 |S|; 0 = off
  core::Vec2 body_force = {0, 0};  // per volume
  bool periodic_x = false, periodic_y = false;

  /// Relaxation rate of the shear moments, 1 / (3 nu + 1/2).
  double omega() const { return 1 / (3 * viscosity + 0.5); }
};

/// Populations less their rest values, f_i - w_i: [9][ny + 2][pitch], one ring of ghost cells.
template <class Real>
using Populations = Kokkos::View<Real***, Kokkos::LayoutRight>;
using CellMask = Kokkos::View<std::uint8_t**, Kokkos::LayoutRight>;

/// State of the fluid in lattice units. Cell (i, j), 0 <= i < nx, 0 <= j < ny, stands at
/// origin + (i + 1/2, j + 1/2) and in the arrays at [j + 1][i + 1].
template <class Real>
struct Fluid {
  int nx = 0, ny = 0;
  core::Vec2 origin = {0, 0};
  core::Symmetry symmetry = core::Symmetry::planar;
  Model model;

  Populations<Real> f;       // after collision
  Populations<Real> f_next;  // where the next step is written
  CellMask active;           // 1 where there is fluid, 0 in walls and bodies   [ny + 2][pitch]
  Populations<Real> force;   // per volume [2][ny + 2][pitch]; empty unless a body spreads force

  /// Whether the first row lies on the axis of revolution.
  bool has_axis() const { return symmetry == core::Symmetry::axisymmetric && origin[1] == 0; }
};

/// Fluid at rest with density 1, every cell active.
template <class Real>
Fluid<Real> make_fluid(int nx, int ny, core::Vec2 origin, core::Symmetry symmetry,
                       Model const& model);

/// Allocates the force field, zero.
template <class Real>
void use_force_field(Fluid<Real>& fluid);

/// Density (less 1) and velocity of one cell.
struct CellState {
  double rho, ux, uy;
};

/// Sets every cell to the equilibrium of the given state, seen from the host.
/// @param state  [ny][nx]
template <class Real>
void set_equilibrium(Fluid<Real>& fluid, Kokkos::View<CellState**, Kokkos::HostSpace> const& state);

/// Density less 1 and velocity of every cell; zero in walls and bodies. Velocities are those of the
/// populations after collision less half the sources, that is of the mid-step.   [ny][nx]
template <class Real>
Kokkos::View<CellState**, Kokkos::HostSpace> cell_states(Fluid<Real> const& fluid);

}  // namespace velum::lbm
