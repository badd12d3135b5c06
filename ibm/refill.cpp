#include "ibm/refill.hpp"

#include "lbm/moments.hpp"

namespace velum::ibm {

template <class Real>
void refill(lbm::Fluid<Real>& fluid, std::vector<Uncovered> const& sites)
{
  if (sites.empty()) return;
  Kokkos::View<Uncovered*> list("uncovered", sites.size());
  Kokkos::View<Uncovered const*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> const host(
      sites.data(), sites.size());
  Kokkos::deep_copy(list, host);
  auto const f = fluid.f;
  Kokkos::parallel_for(
      "velum::ibm::refill", int(sites.size()), KOKKOS_LAMBDA(int k) {
        Uncovered const s = list(k);
        double rho = 0, ux = 0, uy = 0, neq[9] = {};
        int count = 0;
        for (int d = 1; d < 9; ++d) {
          if (!(s.neighbours >> d & 1u)) continue;
          int const i = s.i + 1 + lbm::D2Q9::cx(d), j = s.j + 1 + lbm::D2Q9::cy(d);
          double site[9], r, jx, jy;
          for (int m = 0; m < 9; ++m) site[m] = double(f(m, j, i));
          lbm::density_and_momentum(site, r, jx, jy);
          double const vx = jx / (1 + r), vy = jy / (1 + r);
          for (int m = 0; m < 9; ++m) neq[m] += site[m] - lbm::equilibrium(m, r, vx, vy);
          rho += r;
          ux += vx;
          uy += vy;
          ++count;
        }
        if (count == 0) return;
        double const share = 1.0 / count;
        for (int m = 0; m < 9; ++m)
          f(m, s.j + 1, s.i + 1) =
              Real(lbm::equilibrium(m, share * rho, share * ux, share * uy) + share * neq[m]);
      });
}

template void refill(lbm::Fluid<float>&, std::vector<Uncovered> const&);
template void refill(lbm::Fluid<double>&, std::vector<Uncovered> const&);

}  // namespace velum::ibm
