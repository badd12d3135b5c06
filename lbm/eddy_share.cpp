#include "lbm/eddy_share.hpp"

#include "lbm/formats.hpp"

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

#define VELUM_INSTANTIATE(Real, L, Stored) \
  template void spare_walls(Fluid<Real, L, Stored>&, std::vector<WallHit> const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
