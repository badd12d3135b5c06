#include "lbm/bounce_back.hpp"

#include "lbm/formats.hpp"

namespace velum::lbm {

template <class Real, class L, class Stored>
double bounce_back(Fluid<Real, L, Stored>& fluid, LinkList const& list, core::Vec3 u_wall)
{
  Fluid<Real, L, Stored> const to = fluid;
  auto const links = list.links;
  double mass = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::bounce_back", list.size,
      KOKKOS_LAMBDA(int n, double& sum) {
        Link const l = links(n);
        int const cell = to.cell(l.i, l.j, l.k);
        auto const heard = echo(to, cell, l);
        double const cu = l.weight * along<L>(l.dir, u_wall);
        Real const back = heard.back - Real(wall_coefficient<L>(l, 1, to.model.viscosity) * cu);
        to.f.set_arriving(L::opposite(l.dir), cell, back);
        sum +=
            link_ring<L>(to.symmetry, to.origin[1] + l.j + 0.5, l.dir) * double(back - heard.out);
      },
      mass);
  return mass;
}

#define VELUM_INSTANTIATE(Real, L, Stored) \
  template double bounce_back(Fluid<Real, L, Stored>&, LinkList const&, core::Vec3);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
