#include "lbm/fluid.hpp"

#include "lbm/moments.hpp"

namespace velum::lbm {

namespace {

constexpr int padded(int n)
{
  // Rows a multiple of a cache line apart, but never a power of two: nine streams of equal low
  // address bits would evict each other.
  int const p = (n + 2 + 15) / 16 * 16;
  return p % 128 == 0 ? p + 16 : p;
}

}  // namespace

template <class Real>
Fluid<Real> make_fluid(int nx, int ny, core::Vec2 origin, core::Symmetry symmetry,
                       Model const& model)
{
  Fluid<Real> fluid;
  fluid.nx = nx;
  fluid.ny = ny;
  fluid.origin = origin;
  fluid.symmetry = symmetry;
  fluid.model = model;
  int const pitch = padded(nx);
  fluid.f = Populations<Real>("f", 9, ny + 2, pitch);
  fluid.f_next = Populations<Real>("f_next", 9, ny + 2, pitch);
  fluid.active = CellMask("active", ny + 2, pitch);
  auto const active_host = Kokkos::create_mirror_view(fluid.active);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) active_host(j + 1, i + 1) = 1;
  Kokkos::deep_copy(fluid.active, active_host);
  return fluid;
}

template <class Real>
void use_force_field(Fluid<Real>& fluid)
{
  fluid.force = Populations<Real>("force", 2, fluid.f.extent(1), fluid.f.extent(2));
}

template <class Real>
void set_equilibrium(Fluid<Real>& fluid, Kokkos::View<CellState**, Kokkos::HostSpace> const& state)
{
  auto const f_host = Kokkos::create_mirror_view(fluid.f);
  Kokkos::deep_copy(f_host, fluid.f);
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i)
      for (int k = 0; k < 9; ++k) {
        CellState const& s = state(j, i);
        f_host(k, j + 1, i + 1) = equilibrium<Real>(k, Real(s.rho), Real(s.ux), Real(s.uy));
      }
  Kokkos::deep_copy(fluid.f, f_host);
}

template <class Real>
Kokkos::View<CellState**, Kokkos::HostSpace> cell_states(Fluid<Real> const& fluid)
{
  auto const f_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.f);
  auto const active_host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), fluid.active);
  auto const force = fluid.model.body_force;
  Kokkos::View<CellState**, Kokkos::HostSpace> state("cell_states", fluid.ny, fluid.nx);
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i) {
      if (!active_host(j + 1, i + 1)) continue;
      double f[9], rho, jx, jy;
      for (int k = 0; k < 9; ++k) f[k] = f_host(k, j + 1, i + 1);
      density_and_momentum(f, rho, jx, jy);
      state(j, i) = {rho, (jx - force[0] / 2) / (1 + rho), (jy - force[1] / 2) / (1 + rho)};
    }
  return state;
}

template Fluid<float> make_fluid(int, int, core::Vec2, core::Symmetry, Model const&);
template Fluid<double> make_fluid(int, int, core::Vec2, core::Symmetry, Model const&);
template void use_force_field(Fluid<float>&);
template void use_force_field(Fluid<double>&);
template void set_equilibrium(Fluid<float>&, Kokkos::View<CellState**, Kokkos::HostSpace> const&);
template void set_equilibrium(Fluid<double>&, Kokkos::View<CellState**, Kokkos::HostSpace> const&);
template Kokkos::View<CellState**, Kokkos::HostSpace> cell_states(Fluid<float> const&);
template Kokkos::View<CellState**, Kokkos::HostSpace> cell_states(Fluid<double> const&);

}  // namespace velum::lbm
