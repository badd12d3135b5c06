#pragma once
#include "lbm/link.hpp"

namespace velum::lbm {

/// Force of the fluid on a resting wall by momentum exchange over its links,
///   F = sum c (f_out + f_back),
/// with f_back what bounce_back() will return in this step. Ladd, J. Fluid Mech. 271 (1994) 285;
/// with interpolated walls Mei, Yu, Shyy & Luo, Phys. Rev. E 65 (2002) 041203,
/// doi:10.1103/PhysRevE.65.041203. Populations are deviations from rest, so the pressure of the
/// rest state is left out: on a closed body it adds nothing. Links are weighted by their ring; of a
/// body of revolution only the first component is a force.
/// @pre   after fill_ghosts(), before bounce_back()
/// @return lattice units; planar per unit depth
template <class Real, class L, class Stored>
core::Vec3 wall_force(Fluid<Real, L, Stored> const& fluid, LinkList const& list);

}  // namespace velum::lbm
