#include "lbm/bounce_back.hpp"

namespace velum::lbm {

template <class Real>
double bounce_back(Fluid<Real>& fluid, LinkList const& list, core::Vec2 u_wall)
{
  auto const f = fluid.f;
  auto const links = list.links;
  auto const symmetry = fluid.symmetry;
  double const y0 = fluid.origin[1];
  double mass = 0;
  Kokkos::parallel_reduce(
      "velum::lbm::bounce_back", list.size,
      KOKKOS_LAMBDA(int k, double& sum) {
        Link const l = links(k);
        int const o = D2Q9::opposite(l.dir), cx = D2Q9::cx(l.dir), cy = D2Q9::cy(l.dir);
        int const i = l.i + 1, j = l.j + 1;
        Real const out = f(l.dir, j, i);
        Real const behind = l.second ? f(l.dir, j - cy, i - cx) : out;
        double const cu = l.weight * (cx * u_wall[0] + cy * u_wall[1]);
        Real const back = reflect(out, behind, f(o, j, i), l.q, l.second != 0) -
                          Real(wall_coefficient(l.dir, 1, l.q) * cu);
        f(o, j + cy, i + cx) = back;
        sum += link_ring(symmetry, y0 + l.j + 0.5, l.dir) * double(back - out);
      },
      mass);
  return mass;
}

template double bounce_back(Fluid<float>&, LinkList const&, core::Vec2);
template double bounce_back(Fluid<double>&, LinkList const&, core::Vec2);

}  // namespace velum::lbm
