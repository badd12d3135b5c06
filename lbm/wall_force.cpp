#include "lbm/wall_force.hpp"

namespace velum::lbm {

template <class Real>
core::Vec2 wall_force(Fluid<Real> const& fluid, LinkList const& list)
{
  auto const f = fluid.f;
  auto const links = list.links;
  auto const symmetry = fluid.symmetry;
  double const y0 = fluid.origin[1];
  double x = 0, y = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::wall_force", list.size,
      KOKKOS_LAMBDA(int k, double& fx, double& fy) {
        Link const l = links(k);
        int const o = D2Q9::opposite(l.dir), cx = D2Q9::cx(l.dir), cy = D2Q9::cy(l.dir);
        int const i = l.i + 1, j = l.j + 1;
        Real const out = f(l.dir, j, i);
        Real const behind = l.second ? f(l.dir, j - cy, i - cx) : out;
        Real const back = reflect(out, behind, f(o, j, i), l.q, l.second != 0);
        double const exchanged =
            link_ring(symmetry, y0 + l.j + 0.5, l.dir) * (double(out) + double(back));
        fx += cx * exchanged;
        fy += cy * exchanged;
      },
      x, y);
  return {x, y};
}

template core::Vec2 wall_force(Fluid<float> const&, LinkList const&);
template core::Vec2 wall_force(Fluid<double> const&, LinkList const&);

}  // namespace velum::lbm
