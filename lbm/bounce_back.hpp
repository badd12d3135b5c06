#pragma once
#include "lbm/link.hpp"

namespace velum::lbm {

/// Boundary: wall. Source: Bouzidi, Firdaouss & Lallemand 2001 with the moving-wall term of Ladd,
/// J. Fluid Mech. 271 (1994) 285. Imposes: fluid velocity u_wall * weight at the true distance q.
/// Order: 2. Limits: mass is exact for q = 1/2 only; elsewhere the error is of second order in the
/// velocity gradient and is what this function returns.
/// @param u_wall  velocity of the wall, lattice units
/// @return mass that entered the fluid in this step, weighted by the ring of each link
template <class Real, class L, class Stored>
double bounce_back(Fluid<Real, L, Stored>& fluid, LinkList const& list, core::Vec3 u_wall);

}  // namespace velum::lbm
