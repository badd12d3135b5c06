#pragma once
#include <array>

#include "core/grid.hpp"
#include "lbm/fluid.hpp"
#include "lbm/walls.hpp"

namespace velum::cases {

/// What is needed to read a flow between its cells.
struct Sampled {
  core::Grid const& grid;
  lbm::Walls const& walls;
  lbm::CellStates cells;  // [nz ny][nx]
  std::array<bool, 3> periodic;
};

/// Density less 1 and velocity at a place, lattice units; third order in the size of the cells.
/// Among fluid alone the parabolas through three cells along each axis; where a wall is near, or
/// the place is on it, the parabola that fits the fluid cells within three cells best.
/// @param p  metres, in the domain
lbm::CellState state_at(Sampled const& flow, core::Vec3 const& p);

}  // namespace velum::cases
