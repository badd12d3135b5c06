#pragma once
#include <vector>

#include "ibm/cells.hpp"
#include "lbm/fluid.hpp"

namespace velum::ibm {

/// Connected regions of fluid: two cells belong together when a population can travel from one to
/// the other. Sealing is a statement about these.
struct Regions {
  int count = 0;
  std::vector<int> of;  // [ny][nx], -1 where there is no fluid
};

template <class Real>
Regions connected_regions(lbm::Fluid<Real> const& fluid, Cells const& cells);

}  // namespace velum::ibm
