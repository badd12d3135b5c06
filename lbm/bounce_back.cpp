#include "lbm/bounce_back.hpp"

#include "lbm/lattice/d3q19.hpp"
#include "lbm/lattice/d3q27.hpp"

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
        auto const heard = echo(to.f, cell, l);
        double const cu = l.weight * along<L>(l.dir, u_wall);
        Real const back = heard.back - Real(wall_coefficient<L>(l.dir, 1, l.q) * cu);
        to.f.set_arriving(L::opposite(l.dir), cell, back);
        sum +=
            link_ring<L>(to.symmetry, to.origin[1] + l.j + 0.5, l.dir) * double(back - heard.out);
      },
      mass);
  return mass;
}

template <class Real, class L, class Stored>
core::Vec3 wall_force(Fluid<Real, L, Stored> const& fluid, LinkList const& list)
{
  Fluid<Real, L, Stored> const from = fluid;
  auto const links = list.links;
  core::Vec3 force;
  Kokkos::parallel_reduce(
      "velum::lbm::wall_force", list.size,
      KOKKOS_LAMBDA(int n, double& x, double& y, double& z) {
        Link const l = links(n);
        int const cell = from.cell(l.i, l.j, l.k);
        double const both = link_ring<L>(from.symmetry, from.origin[1] + l.j + 0.5, l.dir) *
                            (double(from.f.outgoing(l.dir, cell)) +
                             double(from.f.arriving(L::opposite(l.dir), cell)));
        x += both * L::c(l.dir, 0);
        y += both * L::c(l.dir, 1);
        if (L::D == 3) z += both * L::c(l.dir, L::D - 1);
      },
      force[0], force[1], force[2]);
  return force;
}

template double bounce_back(Fluid<double, D2Q9, double>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<float, D2Q9, float>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<float, D2Q9, std::int16_t>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<double, D3Q19, double>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<float, D3Q19, float>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<float, D3Q19, std::int16_t>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<double, D3Q27, double>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<float, D3Q27, float>&, LinkList const&, core::Vec3);
template double bounce_back(Fluid<float, D3Q27, std::int16_t>&, LinkList const&, core::Vec3);
template core::Vec3 wall_force(Fluid<double, D2Q9, double> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<float, D2Q9, float> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<float, D2Q9, std::int16_t> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<double, D3Q19, double> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<float, D3Q19, float> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<float, D3Q19, std::int16_t> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<double, D3Q27, double> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<float, D3Q27, float> const&, LinkList const&);
template core::Vec3 wall_force(Fluid<float, D3Q27, std::int16_t> const&, LinkList const&);

}  // namespace velum::lbm
