#include "lbm/initial_stress.hpp"

#include "lbm/formats.hpp"

namespace velum::lbm {

namespace {

/// A neighbour along an axis: across a periodic side, or the cell itself where the box ends.
KOKKOS_INLINE_FUNCTION int beside(int at, int size, bool periodic)
{
  if (at >= 0 && at < size) return at;
  if (periodic) return at < 0 ? at + size : at - size;
  return at < 0 ? 0 : size - 1;
}

template <class States>
KOKKOS_INLINE_FUNCTION core::Vec3 velocity_at(States const& state, int ny, int const (&cell)[3])
{
  CellState const& s = state(cell[2] * ny + cell[1], cell[0]);
  return {s.ux, s.uy, s.uz};
}

}  // namespace

template <class Real, class L, class Stored>
void add_viscous_stress(Fluid<Real, L, Stored>& fluid, CellStates const& host)
{
  auto const state = Kokkos::create_mirror_view_and_copy(
      typename Kokkos::DefaultExecutionSpace::memory_space(), host);
  Fluid<Real, L, Stored> const to = fluid;
  double const factor = -(1 / fluid.model.omega() - 1) * 2 / 3;
  Kokkos::parallel_for(
      "velum::lbm::add_viscous_stress", Kokkos::RangePolicy<>(0, fluid.cells()),
      KOKKOS_LAMBDA(long c) {
        int const cell = to.cell_of(c);
        if (!to.active(cell)) return;
        long const row = c / to.nx;
        int const at[3] = {int(c % to.nx), int(row % to.ny), int(row / to.ny)};
        int const size[3] = {to.nx, to.ny, to.nz};
        double gradient[L::D][L::D], trace = 0;  // of component b along a
        for (int a = 0; a < L::D; ++a) {
          int below[3] = {at[0], at[1], at[2]}, above[3] = {at[0], at[1], at[2]};
          below[a] = beside(at[a] - 1, size[a], to.model.periodic(a));
          above[a] = beside(at[a] + 1, size[a], to.model.periodic(a));
          bool const ends = !to.model.periodic(a) && (at[a] == 0 || at[a] == size[a] - 1);
          core::Vec3 const change =
              velocity_at(state, to.ny, above) - velocity_at(state, to.ny, below);
          for (int b = 0; b < L::D; ++b) gradient[a][b] = change[b] / (ends ? 1 : 2);
          trace += gradient[a][a];
        }
        for (int d = 0; d < L::Q; ++d) {
          double sum = 0;
          for (int a = 0; a < L::D; ++a)
            for (int b = 0; b < L::D; ++b) {
              double const strain =
                  (gradient[a][b] + gradient[b][a]) / 2 - (a == b ? trace / L::D : 0);
              sum += (L::c(d, a) * L::c(d, b) - (a == b ? 1.0 / 3 : 0)) * strain;
            }
          Real const stress = Real(4.5 * L::w(d) * factor * sum);
          to.f.set_outgoing(d, cell, to.f.outgoing(d, cell) + stress);
        }
      });
}

#define VELUM_INSTANTIATE(Real, L, Stored) \
  template void add_viscous_stress(Fluid<Real, L, Stored>&, CellStates const&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
