#pragma once
#include "ibm/peskin4.hpp"
#include "lbm/fluid.hpp"

namespace velum::ibm {

/// Cells in reach of one marker: cell (i[a], j[b]) has the weight  scale x[a] y[b]  where it holds
/// fluid and none elsewhere.
///
/// Part of the kernel that falls on solid cells or out of the box is cut off, and what is left is
/// divided by its sum: a constant velocity is still read as it is and a force arrives whole, but it
/// acts on fewer cells. A marker with less than a quarter of its kernel in fluid (about half a cell
/// inside a flat wall) is dropped, scale 0.
/// Part that falls below the axis is reflected: the component across the axis with reversed sign.
struct Stencil {
  int i[Peskin4::width], j[Peskin4::width];
  double x[Peskin4::width], y[Peskin4::width];
  double mirror[Peskin4::width];  // of row b: -1 for a reflected one, else 1
  int j_min, j_max;
  double scale;
};
using Stencils = Kokkos::View<Stencil*>;
using MarkerField = Kokkos::View<double**, Kokkos::LayoutRight>;  // [components][markers]

/// Least share of the kernel in fluid with which a marker still counts.
constexpr double least_share = 0.25;

/// Finds the stencils of the first n markers.
/// @param X  positions, lattice units [2][markers]
template <class Real>
void locate(lbm::Fluid<Real> const& fluid, MarkerField const& X, Stencils const& stencils, int n);

/// Velocity and density of the arrived populations at the markers, U = sum u(x) delta(x - X), the
/// velocity with half the body force in it.
/// @param U  result: u_x, u_y, density, and 1 or 0 for a marker dropped [4][markers]
template <class Real>
void interpolate(lbm::Fluid<Real> const& fluid, Stencils const& stencils, MarkerField const& U,
                 int n);

/// Sets the force field to  f(x) = sum F delta(x - X) / ring(x), the adjoint of interpolate():
///   sum ring(x) u . f = sum U . F.
/// Each row gathers from the markers in their order, so the sum has the same bits in every run.
/// @param F  force on the fluid, of the full ring [2][markers]
template <class Real>
void spread(lbm::Fluid<Real> const& fluid, Stencils const& stencils, MarkerField const& F, int n);

}  // namespace velum::ibm
