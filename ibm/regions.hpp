#pragma once
#include <vector>

#include "ibm/cells.hpp"
#include "lbm/fluid.hpp"

namespace velum::ibm {

/// Connected regions of fluid: two cells belong together when a population can travel from one to
/// the other. Sealing is a statement about these.
struct Regions {
  /// Cells of one region along a row.
  struct Run {
    int row, first, last, region;
  };
  int count = 0;
  std::vector<int> of;    // [ny][nx], -1 where there is no fluid
  std::vector<Run> runs;  // all its cells, row by row
};

template <class Real>
Regions connected_regions(lbm::Fluid<Real> const& fluid, Cells const& cells);

}  // namespace velum::ibm
