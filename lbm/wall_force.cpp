#include "lbm/wall_force.hpp"

#include "lbm/formats.hpp"

namespace velum::lbm {

template <class Real, class L, class Stored>
core::Vec3 wall_force(Fluid<Real, L, Stored> const& fluid, LinkList const& list)
{
  Fluid<Real, L, Stored> const from = fluid;
  auto const links = list.links;
  core::Vec3 force;
  Kokkos::parallel_reduce(
      "velum::lbm::wall_force", list.size,
      KOKKOS_LAMBDA(int n, double& fx, double& fy, double& fz) {
        Link const l = links(n);
        auto const heard = echo(from, from.cell(l.i, l.j, l.k), l);
        double const exchanged = link_ring<L>(from.symmetry, from.origin[1] + l.j + 0.5, l.dir) *
                                 (double(heard.out) + double(heard.back));
        fx += L::c(l.dir, 0) * exchanged;
        fy += L::c(l.dir, 1) * exchanged;
        if constexpr (L::D == 3) fz += L::c(l.dir, 2) * exchanged;
      },
      force[0], force[1], force[2]);
  return force;
}

#define VELUM_INSTANTIATE(Real, L, Stored) \
  template core::Vec3 wall_force(Fluid<Real, L, Stored> const&, LinkList const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
