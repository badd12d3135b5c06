#pragma once
#include "lbm/walls.hpp"

namespace velum::lbm {

/// Switches the eddy viscosity off in the two layers of cells next to walls: there the shear is
/// that of the boundary layer, not of eddies, and in a gap a few cells wide Smagorinsky's model
/// would cost up to half of the flow. A cell is spared when it, or one that touches it, has a link
/// to a wall.
/// @param hits  of the walls, without those of openings
/// @pre   the fluid has an eddy share
template <class Real, class L, class Stored>
void spare_walls(Fluid<Real, L, Stored>& fluid, std::vector<WallHit> const& hits);

}  // namespace velum::lbm
