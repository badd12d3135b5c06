#include "lbm/eddy_share.hpp"

#include "lbm/lattice/d3q19.hpp"
#include "lbm/lattice/d3q27.hpp"

namespace velum::lbm {

template <class Real, class L, class Stored>
void spare_walls(Fluid<Real, L, Stored>& fluid, std::vector<WallHit> const& hits)
{
  auto const host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.eddy_share);
  for (WallHit const& h : hits) {
    host(fluid.cell(h.i, h.j, h.k)) = 0;
    for (int dir = 1; dir < L::Q; ++dir) {
      Neighbour const n = neighbour(fluid, h.i, h.j, dir, h.k);
      if (n.i >= 0) host(fluid.cell(n.i, n.j, n.k)) = 0;
    }
  }
  Kokkos::deep_copy(fluid.eddy_share, host);
}

template void spare_walls(Fluid<double, D2Q9, double>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<float, D2Q9, float>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<float, D2Q9, std::int16_t>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<double, D3Q19, double>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<float, D3Q19, float>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<float, D3Q19, std::int16_t>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<double, D3Q27, double>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<float, D3Q27, float>&, std::vector<WallHit> const&);
template void spare_walls(Fluid<float, D3Q27, std::int16_t>&, std::vector<WallHit> const&);

}  // namespace velum::lbm
