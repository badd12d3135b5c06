#pragma once
#include <Kokkos_Core.hpp>
#include <cmath>
#include <cstdint>

#include "core/symmetry.hpp"
#include "core/vec.hpp"
#include "lbm/lattice/d2q9.hpp"
#include "lbm/populations.hpp"
#include "lbm/spans.hpp"

namespace velum::lbm {

enum class Collision { bgk, trt, recursive_regularised, central_moments, cumulant };

/// Where a wall reflects: at its true distance along each link, found by a parabola through three
/// populations or a line through two (lbm/link.hpp), or half-way along it wherever it is, a
/// staircase of first order.
enum class WallRule { quadratic, linear, half_way };

/// Whether a collision is defined on a lattice of so many directions: cumulants need D3Q27.
constexpr bool is_defined(Collision collision, int directions)
{
  return collision != Collision::cumulant || directions == 27;
}

/// Whether walls can take a rule with a collision: parabolas want odd moments that relax by their
/// product with the viscosity and even ones at rate 1 (lbm/link.hpp).
constexpr bool is_defined(Collision collision, WallRule rule)
{
  return rule != WallRule::quadratic || collision == Collision::central_moments;
}

/// Speed, as a cell Reynolds number |u| dx / nu, at which the odd moments of central moments go
/// over from the rate that is right at walls to the rate 1 that is robust in the stream
/// (lbm/odd_moments.hpp).
inline constexpr double robust_from = 2;

/// What the fluid is and how it relaxes, lattice units.
struct Model {
  Collision collision = Collision::central_moments;
  double viscosity = 0.1;
  double magic = 1.0 / 8;
  double smagorinsky = 0;      // constant C of nu_t = (C dx)^2 |S|; 0 = off
  core::Vec3 body_force = {};  // per volume
  bool periodic_x = false, periodic_y = false, periodic_z = false;
  unsigned mirrors = 0;      // sides of the box that are planes of symmetry: bit of mirror()
  double storage_range = 4;  // of 16-bit storage: largest |f_i - w_i| / w_i
  WallRule wall_rule = WallRule::quadratic;

  /// Relaxation rate of the shear moments, 1 / (3 nu + 1/2).
  KOKKOS_FUNCTION double omega() const { return 1 / (3 * viscosity + 0.5); }
  /// That of the trace of the second moments.
  KOKKOS_FUNCTION double bulk_rate() const
  {
    return collision == Collision::central_moments || collision == Collision::cumulant ? 1
                                                                                       : omega();
  }
  bool periodic(int axis) const
  {
    return axis == 0 ? periodic_x : axis == 1 ? periodic_y : periodic_z;
  }
};

/// Range of 16-bit storage for a flow no faster than u in a lattice of D dimensions: of the second-
/// order equilibrium along the longest direction, with half as much again for density and stress.
inline double storage_range_for(double u, int dimensions)
{
  double const cu = u * std::sqrt(double(dimensions));
  return 1.5 * (3 * cu + 4.5 * cu * cu);
}

/// Bit of a side of the box in Model::mirrors: across an axis, at its lower or upper end.
constexpr unsigned mirror(int axis, bool upper) { return 1u << (2 * axis + (upper ? 1 : 0)); }

using CellMask = Kokkos::View<std::uint8_t*>;

/// State of the fluid in lattice units. Cell (i, j, k), 0 <= i < nx ..., stands at
/// origin + (i + 1/2, j + 1/2, k + 1/2); arrays over the cells have one ring of ghost cells and are
/// indexed by cell(i, j, k). A plane lattice has nz = 1 and no ghosts across z.
/// @tparam Real    of the arithmetic
/// @tparam L       the lattice
/// @tparam Stored  of the populations in memory
template <class Real, class L = D2Q9, class Stored = Real>
struct Fluid {
  int nx = 0, ny = 0, nz = 1;
  core::Vec<double, L::D> origin = {};
  core::Symmetry symmetry = core::Symmetry::planar;
  Model model;

  Populations<Real, L, Stored> f;
  CellMask active;  // not 0 where there is fluid: its side of a body
  Spans spans;      // the runs of fluid along x; mark() keeps them in step with active
  Kokkos::View<Real**, Kokkos::LayoutRight> force;  // per volume [D][cells]; empty unless a body
                                                    // spreads force, or a body force acts
  Kokkos::View<Real*> eddy_share;  // factor on C^2 [cells]; empty where no eddy viscosity acts

  /// Whether the first row lies on the axis of revolution.
  bool has_axis() const { return symmetry == core::Symmetry::axisymmetric && origin[1] == 0; }

  KOKKOS_FORCEINLINE_FUNCTION int cell(int i, int j, int k = 0) const
  {
    return (L::D == 3 ? (k + 1) * f.plane : 0) + (j + 1) * f.pitch + i + 1;
  }
  /// Cell number n of the box, counted along x first.
  KOKKOS_FORCEINLINE_FUNCTION int cell_of(long n) const
  {
    long const row = n / nx;
    return cell(int(n % nx), int(row % ny), int(row / ny));
  }
  /// Number of all cells of the box, fluid or not.
  long cells() const { return long(nx) * ny * nz; }
};

/// Fluid at rest with density 1, every cell active.
template <class Real, class L = D2Q9, class Stored = Real>
Fluid<Real, L, Stored> make_fluid(int nx, int ny, core::Vec<double, L::D> origin,
                                  core::Symmetry symmetry, Model const& model, int nz = 1);

/// Sets which cells hold fluid, and the spans with them.
/// @param mask  over the box, [nz][ny][nx]: 0 none, else the side of a body
template <class Real, class L, class Stored>
void mark(Fluid<Real, L, Stored>& fluid, std::vector<std::uint8_t> const& mask);

/// Allocates the factor on the eddy viscosity, 1 everywhere. make_fluid() does where the model asks
/// for Smagorinsky's constant.
template <class Real, class L, class Stored>
void use_eddy_share(Fluid<Real, L, Stored>& fluid);

/// Allocates the force field, zero.
template <class Real, class L, class Stored>
void use_force_field(Fluid<Real, L, Stored>& fluid);

/// Density (less 1) and velocity of one cell. The density is that of fluid at rest under the cell's
/// pressure, 1 + 3 p: about an axis it is not the sum of the populations (lbm/pressure.hpp).
struct CellState {
  double rho, ux, uy, uz = 0;
};
using CellStates = Kokkos::View<CellState**, Kokkos::HostSpace>;  // [nz ny][nx]

/// Sets every cell to the equilibrium of the given state, seen from the host.
template <class Real, class L, class Stored>
void set_equilibrium(Fluid<Real, L, Stored>& fluid, CellStates const& state);

/// State of every cell; zero in walls and bodies. Velocities are those of the populations after
/// collision less half the force, that is of the mid-step.
template <class Real, class L, class Stored>
CellStates cell_states(Fluid<Real, L, Stored> const& fluid);

}  // namespace velum::lbm
