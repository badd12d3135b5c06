#pragma once
#include <memory>
#include <span>

#include "contact/surface_contact.hpp"
#include "structure/load.hpp"
#include "structure/sheet.hpp"
#include "structure/static_solve.hpp"

namespace velum::ibm {

struct SurfaceEquilibrium {
  int rounds = 0;      ///< of following and solving
  int iterations = 0;  ///< linear solves of all rounds
  double moved = 0;    ///< of any node in the last round, over the least thickness
};

struct SurfaceEquilibriumOptions {
  double moved = 1e-4;  ///< of any node in a round, over the least thickness, at which it ends
  int rounds = 50;
  structure::StaticOptions solve{};
};

/// Static equilibrium of a sheet that touches itself, or of sheets that merge_sheets() made one of
/// and that touch each other. Newton's method needs points that keep to the plane of a triangle
/// (surface_contact.hpp: `hold`), and those that are nearest change as the sheet moves: hence
/// rounds of contact::follow() and structure::static_solve() until a round moves nothing. A point
/// over the valley between two triangles, to which either is nearest once the other holds it, stays
/// with one of them.
/// @param contact  its `hold` is set and stays so; multipliers stay as they are
/// @param loads    all others
/// Throws core::Divergence where a round finds no equilibrium (static_solve.hpp), or where the
/// rounds do not come to rest: the sentence has how far the last one moved.
SurfaceEquilibrium static_solve(structure::Sheet& sheet,
                                std::shared_ptr<contact::SurfaceContact> const& contact,
                                std::span<structure::Load const> loads,
                                SurfaceEquilibriumOptions const& options = {});

}  // namespace velum::ibm
