#include "ibm/regions.hpp"

namespace velum::ibm {

template <class Real>
Regions connected_regions(lbm::Fluid<Real> const& fluid, Cells const& cells)
{
  Regions regions;
  regions.of.assign(cells.state.size(), -1);
  std::vector<int> open;
  int const nx = fluid.nx;
  for (std::size_t seed = 0; seed < cells.state.size(); ++seed) {
    if (!is_fluid(cells.state[seed]) || regions.of[seed] >= 0) continue;
    regions.of[seed] = regions.count;
    open.push_back(static_cast<int>(seed));
    while (!open.empty()) {
      int const k = open.back();
      open.pop_back();
      for (int dir = 1; dir < lbm::D2Q9::Q; ++dir) {
        auto const n = lbm::neighbour(fluid, k % nx, k / nx, dir);
        if (n.i < 0) continue;
        auto const m = static_cast<std::size_t>(n.j * nx + n.i);
        if (regions.of[m] >= 0 || cells.state[m] != cells.state[static_cast<std::size_t>(k)])
          continue;
        regions.of[m] = regions.count;
        open.push_back(static_cast<int>(m));
      }
    }
    ++regions.count;
  }
  return regions;
}

template Regions connected_regions(lbm::Fluid<float> const&, Cells const&);
template Regions connected_regions(lbm::Fluid<double> const&, Cells const&);

}  // namespace velum::ibm
