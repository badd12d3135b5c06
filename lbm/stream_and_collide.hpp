#pragma once
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// One step of the bulk: every cell pulls the populations that arrive and collides; what walls and
/// openings send back must stand in their slots (lbm/links.hpp) before. Swaps f and f_next.
template <class Real>
void stream_and_collide(Fluid<Real>& fluid);

/// The two halves of the same step, for bodies that read the velocity in between: stream() leaves
/// the arrived populations in f, collide_in_place() collides them with the force field.
template <class Real>
void stream(Fluid<Real>& fluid);
template <class Real>
void collide_in_place(Fluid<Real>& fluid);

/// Fills the ghost row below the axis with the mirror image of the first row, and ghost columns and
/// rows of periodic directions with their opposite sides. First thing of a step.
template <class Real>
void fill_ghosts(Fluid<Real>& fluid);

}  // namespace velum::lbm
