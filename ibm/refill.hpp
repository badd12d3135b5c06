#pragma once
#include "ibm/cells.hpp"
#include "lbm/fluid.hpp"

namespace velum::ibm {

/// A site that the membrane has uncovered and the neighbours it is filled from, a bit per
/// direction.
struct Uncovered {
  int i, j;
  unsigned neighbours;
};

/// Fills uncovered sites with the equilibrium of the mean density and velocity of their neighbours
/// on the same side plus the neighbours' mean non-equilibrium. No extrapolation: it blows up.
template <class Real>
void refill(lbm::Fluid<Real>& fluid, std::vector<Uncovered> const& sites);

}  // namespace velum::ibm
