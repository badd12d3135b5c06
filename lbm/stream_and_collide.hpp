#pragma once
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// One step of the bulk: every cell takes the populations that arrive, collides and sends them off;
/// what walls and openings send back must have been written (fill_ghosts(), bounce_back(), apply())
/// before.
template <class Real, class L, class Stored>
void stream_and_collide(Fluid<Real, L, Stored>& fluid);

/// Writes what arrives through periodic sides, through planes of symmetry, and across the axis,
/// where a population comes back as its mirror image. First thing of a step.
template <class Real, class L, class Stored>
void fill_ghosts(Fluid<Real, L, Stored>& fluid);

}  // namespace velum::lbm
