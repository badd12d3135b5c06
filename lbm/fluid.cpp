#include "lbm/fluid.hpp"

#include "core/host_access.hpp"
#include "core/huge_pages.hpp"
#include "lbm/formats.hpp"
#include "lbm/moments.hpp"
#include "lbm/pressure.hpp"

namespace velum::lbm {

namespace {

/// Cells from one row to the next: room for the ghosts and a vector beyond the row, in whole cache
/// lines of doubles, and never a power of two: the streams of all directions would then evict each
/// other.
constexpr int pitch_for(int nx)
{
  int const p = (nx + 2 + vector_cells + 7) / 8 * 8;
  return p % 64 == 0 ? p + 8 : p;
}

}  // namespace

template <class Real, class L, class Stored>
Fluid<Real, L, Stored> make_fluid(int nx, int ny, core::Vec<double, L::D> origin,
                                  core::Symmetry symmetry, Model const& model, int nz)
{
  Fluid<Real, L, Stored> fluid;
  fluid.nx = nx;
  fluid.ny = ny;
  fluid.nz = L::D == 3 ? nz : 1;
  fluid.origin = origin;
  fluid.symmetry = symmetry;
  fluid.model = model;
  auto& f = fluid.f;
  f.pitch = pitch_for(nx);
  f.plane = f.pitch * (ny + 2);
  f.range = float(model.storage_range);
  // the last row may be updated a vector beyond its end, and its neighbours with it
  std::size_t const cells =
      std::size_t(f.plane) * (L::D == 3 ? fluid.nz + 2 : 1) + std::size_t(f.pitch) + vector_cells;
  f.slots = Kokkos::View<Stored**, Kokkos::LayoutRight>(
      Kokkos::view_alloc(std::string("populations"), Kokkos::WithoutInitializing), L::Q, cells);
  if constexpr (core::on_host)
    core::prefer_huge_pages(f.slots.data(), f.slots.size() * sizeof(Stored));
  // touched first by the threads that will update them
  auto const slots = f.slots;
  Kokkos::parallel_for(
      "velum::lbm::first_touch", cells, KOKKOS_LAMBDA(std::size_t c) {
        for (int i = 0; i < L::Q; ++i) slots(i, c) = Stored(0);
      });
  fluid.active = CellMask("active", cells);
  if (model.smagorinsky > 0) use_eddy_share(fluid);
  if (core::norm(model.body_force) > 0) use_force_field(fluid);
  mark(fluid, std::vector<std::uint8_t>(static_cast<std::size_t>(fluid.cells()), 1));
  return fluid;
}

template <class Real, class L, class Stored>
void mark(Fluid<Real, L, Stored>& fluid, std::vector<std::uint8_t> const& mask)
{
  auto const host = Kokkos::create_mirror_view(fluid.active);
  std::size_t at = 0;
  for (int k = 0; k < fluid.nz; ++k)
    for (int j = 0; j < fluid.ny; ++j)
      for (int i = 0; i < fluid.nx; ++i)
        host(static_cast<std::size_t>(fluid.cell(i, j, k))) = mask[at++];
  Kokkos::deep_copy(fluid.active, host);
  fluid.spans = make_spans(mask, fluid.nx, fluid.ny, fluid.nz, fluid.cell(0, 0, 0), fluid.f.pitch,
                           fluid.f.plane);
}

template <class Real, class L, class Stored>
void use_eddy_share(Fluid<Real, L, Stored>& fluid)
{
  fluid.eddy_share = Kokkos::View<Real*>("eddy_share", fluid.f.slots.extent(1));
  Kokkos::deep_copy(fluid.eddy_share, Real(1));
}

template <class Real, class L, class Stored>
void use_force_field(Fluid<Real, L, Stored>& fluid)
{
  fluid.force = Kokkos::View<Real**, Kokkos::LayoutRight>("force", L::D, fluid.f.slots.extent(1));
  if (fluid.eddy_share.extent(0) == 0) use_eddy_share(fluid);  // the kernel with a force reads it
}

template <class Real, class L, class Stored>
void set_equilibrium(Fluid<Real, L, Stored>& fluid, CellStates const& state)
{
  auto const device = Kokkos::create_mirror_view_and_copy(
      typename Kokkos::DefaultExecutionSpace::memory_space(), state);
  Fluid<Real, L, Stored> const to = fluid;
  int const nx = fluid.nx, ny = fluid.ny;
  Kokkos::parallel_for(
      "velum::lbm::set_equilibrium", Kokkos::RangePolicy<>(0, fluid.cells()),
      KOKKOS_LAMBDA(long c) {
        int const i = int(c % nx), row = int(c / nx);
        CellState const s = device(row, i);
        core::Vec<Real, L::D> u;
        u[0] = Real(s.ux);
        u[1] = Real(s.uy);
        if constexpr (L::D == 3) u[2] = Real(s.uz);
        int const cell = to.cell(i, row % ny, row / ny);
        Real const rho = Real(density_of(to, s.rho, to.origin[1] + row % ny + 0.5, s.uy));
        for (int d = 0; d < L::Q; ++d) to.f.set_outgoing(d, cell, equilibrium<L>(d, rho, u));
      });
}

template <class Real, class L, class Stored>
CellStates cell_states(Fluid<Real, L, Stored> const& fluid)
{
  int const nx = fluid.nx, ny = fluid.ny;
  Kokkos::View<CellState**, Kokkos::LayoutRight> state("cell_states", ny * fluid.nz, nx);
  auto const half = 0.5 * fluid.model.body_force;
  Fluid<Real, L, Stored> const from = fluid;
  Kokkos::parallel_for(
      "velum::lbm::cell_states", Kokkos::RangePolicy<>(0, fluid.cells()), KOKKOS_LAMBDA(long c) {
        int const i = int(c % nx), row = int(c / nx);
        int const cell = from.cell(i, row % ny, row / ny);
        if (!from.active(cell)) return;
        double site[L::Q], rho;
        core::Vec<double, L::D> j;
        for (int d = 0; d < L::Q; ++d) site[d] = double(from.f.outgoing(d, cell));
        density_and_momentum<L>(site, rho, j);
        double const v = 1 / (1 + rho);
        double const uy = v * (j[1] - half[1]);
        state(row, i) = {pressure_of(from, rho, from.origin[1] + row % ny + 0.5, uy),
                         v * (j[0] - half[0]), uy, L::D == 3 ? v * (j[L::D - 1] - half[2]) : 0.0};
      });
  CellStates host("cell_states", ny * fluid.nz, nx);
  Kokkos::deep_copy(host, Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), state));
  return host;
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                                      \
  template Fluid<Real, L, Stored> make_fluid(int, int, core::Vec<double, L::D>, core::Symmetry, \
                                             Model const&, int);                                \
  template void mark(Fluid<Real, L, Stored>&, std::vector<std::uint8_t> const&);                \
  template void use_eddy_share(Fluid<Real, L, Stored>&);                                        \
  template void use_force_field(Fluid<Real, L, Stored>&);                                       \
  template void set_equilibrium(Fluid<Real, L, Stored>&, CellStates const&);                    \
  template CellStates cell_states(Fluid<Real, L, Stored> const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
