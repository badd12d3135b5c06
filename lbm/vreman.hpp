#pragma once
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// What Vreman's closure needs beside the fluid. Arrays are over the fluid's cells and their ring.
template <class Real>
struct Vreman {
  double constant = 0.025;                             // C_V, about 5/2 of Smagorinsky's C^2
  Kokkos::View<Real**, Kokkos::LayoutRight> velocity;  // [D][cells]
  CellMask side;                                       // fluid.active with its images in the ring
};

/// @throws core::InputError  where Smagorinsky's constant C of the fluid is zero
template <class Real, class L, class Stored>
Vreman<Real> make_vreman(Fluid<Real, L, Stored> const& fluid, double constant = 0.025);

/// Sets the factor on the eddy viscosity of every cell to that which gives Vreman's,
///   nu_t = C_V sqrt(B / a_ij a_ij),  a_ij = d_i u_j,
/// B the second invariant of b_ij = dx^2 a_mi a_mj: the sum of the squares of all 2 x 2 minors of
/// a, which is how it is computed, for so it cannot fall below zero. In the plane, where nothing
/// changes along z, there is one minor and nu_t = C_V |det a| / |a|. Vreman, Phys. Fluids 16 (2004)
/// 3670, doi:10.1063/1.1785131.
///
/// Unlike Smagorinsky's it vanishes in plane shear and falls off towards a wall, like the distance
/// (Nicoud, Baya Toda, Cabrit, Bose & Lee, Phys. Fluids 23 (2011) 085106, doi:10.1063/1.3623274),
/// so laminar layers keep their molecular viscosity. It does not vanish in solid rotation, where
/// there is no strain for it to act on.
///
/// The step multiplies C^2 |S|, |S| = sqrt(2 S:S) of the deviator, by the factor, which therefore
/// is nu_t / (C^2 |S|): the fluid's own C cancels. The factor is held until the next call, while
/// the strain it multiplies is that of each step. Hence nu_t is bounded by 10 C_V |S|: a factor
/// from the core of a vortex, where |S| all but vanishes, would be far too large for the strain
/// around it, once that comes by. The bound acts only where |S| is below 1/28 of the vorticity. A
/// call costs about as much as a step; as an eddy takes many steps to pass a cell, one in ten will
/// do.
///
/// Gradients are central differences of the velocities of cell_states(), through periodic sides,
/// mirrors and the axis. The factor is zero where a cell they need is missing: no fluid, outside
/// the box, or on another side of a body, which is the first layer at walls, openings and bodies;
/// and where the gradient is below 1e-7 per step, the rounding of single precision. An axisymmetric
/// fluid is treated as a planar one: the strain u_y / y of the rings is left out. What
/// spare_walls() had set is overwritten.
/// @pre  make_vreman() was given this fluid, whose C must be above zero but may be any
template <class Real, class L, class Stored>
void set_vreman_share(Fluid<Real, L, Stored>& fluid, Vreman<Real> const& vreman);

}  // namespace velum::lbm
