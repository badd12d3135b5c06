#include "ibm/refill.hpp"

#include "lbm/moments.hpp"

namespace velum::ibm {

using lbm::D2Q9;

template <class Real>
void refill(lbm::Fluid<Real>& fluid, std::vector<Uncovered> const& sites)
{
  if (sites.empty()) return;
  Kokkos::View<Uncovered*> list("uncovered", sites.size());
  Kokkos::View<Uncovered const*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> const host(
      sites.data(), sites.size());
  Kokkos::deep_copy(list, host);
  lbm::Fluid<Real> const to = fluid;
  Kokkos::parallel_for(
      "velum::ibm::refill", int(sites.size()), KOKKOS_LAMBDA(int k) {
        Uncovered const s = list(k);
        double rho = 0, neq[9] = {};
        core::Vec2 u = {0, 0};
        int count = 0;
        for (int d = 1; d < 9; ++d) {
          if (!(s.neighbours >> d & 1u)) continue;
          int const cell = to.cell(s.i + D2Q9::cx(d), s.j + D2Q9::cy(d));
          double site[9], r;
          core::Vec2 v;
          for (int m = 0; m < 9; ++m) site[m] = double(to.f.outgoing(m, cell));
          lbm::density_and_momentum<D2Q9>(site, r, v);
          v *= 1 / (1 + r);
          for (int m = 0; m < 9; ++m) neq[m] += site[m] - lbm::equilibrium<D2Q9>(m, r, v);
          rho += r;
          u += v;
          ++count;
        }
        if (count == 0) return;
        double const share = 1.0 / count;
        for (int m = 0; m < 9; ++m)
          to.f.set_outgoing(
              m, to.cell(s.i, s.j),
              Real(lbm::equilibrium<D2Q9>(m, share * rho, share * u) + share * neq[m]));
      });
}

template void refill(lbm::Fluid<float>&, std::vector<Uncovered> const&);
template void refill(lbm::Fluid<double>&, std::vector<Uncovered> const&);

}  // namespace velum::ibm
