#pragma once
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// What the pressure of an axisymmetric cell has of its radial velocity, u_y / (k y); see
/// pressure_of(). Zero elsewhere.
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION double pressure_ratio(Fluid<Real, L, Stored> const& fluid, double y,
                                                  double uy)
{
  if (fluid.symmetry != core::Symmetry::axisymmetric) return 0;
  return uy / (fluid.model.bulk_rate() * y);
}

/// Pressure of an axisymmetric cell, less that of the rest state and times 3: what the density less
/// 1 is elsewhere.
///
/// The bulk viscosity of the lattice, (1/k - 1/2)/3 at the rate k of the trace, acts on the
/// divergence in the plane, -u_y/y in a flow without one in space. The isotropic part of the
/// momentum flux, which is the pressure that moves the fluid (lbm/collide.hpp), is therefore
///   p = (rho + (1/k - 1/2) rho u_y/y) / 3
/// with the mid-step density rho; what a collision leaves has half a step's source more,
/// rho_out = rho - rho u_y/2y, so
///   3 p = rho_out + rho u_y / (k y).
/// The part with u_y is c_s dx rho u_r/r, whatever the velocity: at low Mach number it is larger
/// than the pressure of the flow.
/// @param rho  density less 1 after a collision;  @param y  radius in cells;  @param uy  velocity
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION double pressure_of(Fluid<Real, L, Stored> const& fluid, double rho,
                                               double y, double uy)
{
  double const ratio = pressure_ratio(fluid, y, uy);
  return (1 + ratio) * rho + ratio;
}

/// The other way round: density less 1 after a collision, of the pressure as pressure_of() gives
/// it.
template <class Real, class L, class Stored>
KOKKOS_FORCEINLINE_FUNCTION double density_of(Fluid<Real, L, Stored> const& fluid, double pressure,
                                              double y, double uy)
{
  double const ratio = pressure_ratio(fluid, y, uy);
  return (pressure - ratio) / (1 + ratio);
}

}  // namespace velum::lbm
