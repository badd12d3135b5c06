#include "lbm/stream_and_collide.hpp"

#include <type_traits>
#include <utility>

#include "lbm/bgk.hpp"
#include "lbm/central_moment.hpp"
#include "lbm/collide.hpp"
#include "lbm/trt.hpp"

namespace velum::lbm {

namespace {

using Space = Kokkos::DefaultExecutionSpace;
constexpr bool on_host =
    Kokkos::SpaceAccessibility<Kokkos::HostSpace, Space::memory_space>::accessible;

/// The nine rows that a row of cells pulls from, and the nine it writes.
template <class Real>
struct Rows {
  Real const* in[9];
  Real* out[9];
  std::uint8_t const* active;
  Real const* Fx;
  Real const* Fy;
  Real inv_y;
};

template <class Real>
struct Constants {
  Real Fx, Fy, smagorinsky_squared;
};

/// One cell of a row: gather, collide, scatter. Cells without fluid are written as zero, so that
/// nothing grows there; selecting by the mask keeps the loop over the row free of branches.
template <bool Axisymmetric, bool Field, class Real, class Rule>
KOKKOS_FORCEINLINE_FUNCTION void update_cell(Rows<Real> const& row, int x, Rule const& rule,
                                             Constants<Real> const& k)
{
  Real f[9] = {row.in[0][x], row.in[1][x], row.in[2][x], row.in[3][x], row.in[4][x],
               row.in[5][x], row.in[6][x], row.in[7][x], row.in[8][x]};
  Real Fx = k.Fx, Fy = k.Fy;
  if constexpr (Field) {
    Fx += row.Fx[x];
    Fy += row.Fy[x];
  }
  collide<Axisymmetric>(f, rule, row.inv_y, Fx, Fy, k.smagorinsky_squared);
  bool const fluid = row.active[x] != 0;
  row.out[0][x] = fluid ? f[0] : Real(0);
  row.out[1][x] = fluid ? f[1] : Real(0);
  row.out[2][x] = fluid ? f[2] : Real(0);
  row.out[3][x] = fluid ? f[3] : Real(0);
  row.out[4][x] = fluid ? f[4] : Real(0);
  row.out[5][x] = fluid ? f[5] : Real(0);
  row.out[6][x] = fluid ? f[6] : Real(0);
  row.out[7][x] = fluid ? f[7] : Real(0);
  row.out[8][x] = fluid ? f[8] : Real(0);
}

/// @param step  1 to pull from the neighbours, 0 to read the row itself
template <bool Field, class Real>
KOKKOS_FORCEINLINE_FUNCTION Rows<Real> rows(Populations<Real> const& from,
                                            Populations<Real> const& to, CellMask const& active,
                                            Populations<Real> const& force, int j, int step,
                                            double y0)
{
  Rows<Real> row;
  for (int i = 0; i < 9; ++i) {
    row.in[i] = &from(i, j + 1 - step * D2Q9::cy(i), 1 - step * D2Q9::cx(i));
    row.out[i] = &to(i, j + 1, 1);
  }
  row.active = &active(j + 1, 1);
  row.Fx = Field ? &force(0, j + 1, 1) : nullptr;
  row.Fy = Field ? &force(1, j + 1, 1) : nullptr;
  row.inv_y = Real(1 / (y0 + j + 0.5));
  return row;
}

/// Rows of x are the unit of work: on the host the loop over a row vectorises, on a GPU one thread
/// takes one cell.
template <bool Axisymmetric, bool Field, class Real, class Rule>
void update(Populations<Real> from, Populations<Real> to, Fluid<Real> const& fluid, bool pull,
            Rule const& rule)
{
  int const nx = fluid.nx, ny = fluid.ny, step = pull ? 1 : 0;
  auto const active = fluid.active;
  auto const force = fluid.force;
  auto const& m = fluid.model;
  double const y0 = fluid.origin[1];
  Constants<Real> const constants{Real(m.body_force[0]), Real(m.body_force[1]),
                                  Real(m.smagorinsky * m.smagorinsky)};
  if constexpr (on_host) {
    Kokkos::parallel_for(
        "velum::lbm::update_rows", Kokkos::RangePolicy<Space>(0, ny), KOKKOS_LAMBDA(int j) {
          Rows<Real> const row = rows<Field>(from, to, active, force, j, step, y0);
          // copies on the stack: what a store might alias is not vectorised
          Rule const r = rule;
          Constants<Real> const k = constants;
          int const n = nx;
#pragma GCC ivdep
          for (int x = 0; x < n; ++x) update_cell<Axisymmetric, Field>(row, x, r, k);
        });
  } else {
    Kokkos::parallel_for(
        "velum::lbm::update_cells", Kokkos::RangePolicy<Space>(0, nx * ny), KOKKOS_LAMBDA(int c) {
          int const j = c / nx;
          update_cell<Axisymmetric, Field>(rows<Field>(from, to, active, force, j, step, y0),
                                           c % nx, rule, constants);
        });
  }
}

template <class Real, class Rule>
void update_with(Populations<Real> from, Populations<Real> to, Fluid<Real> const& fluid, bool pull,
                 Rule const& rule)
{
  bool const axisymmetric = fluid.symmetry == core::Symmetry::axisymmetric;
  bool const field = fluid.force.extent(0) > 0;
  if (axisymmetric && field) return update<true, true>(from, to, fluid, pull, rule);
  if (axisymmetric) return update<true, false>(from, to, fluid, pull, rule);
  if (field) return update<false, true>(from, to, fluid, pull, rule);
  update<false, false>(from, to, fluid, pull, rule);
}

template <class Real>
void update_fluid(Populations<Real> from, Populations<Real> to, Fluid<Real> const& fluid, bool pull)
{
  Real const omega = Real(fluid.model.omega());
  switch (fluid.model.collision) {
    case Collision::bgk:
      return update_with(from, to, fluid, pull, Bgk<Real>{omega});
    case Collision::trt:
      return update_with(from, to, fluid, pull, Trt<Real>{omega, Real(fluid.model.magic)});
    case Collision::central_moments:
      return update_with(from, to, fluid, pull, CentralMoment<Real>{omega});
  }
}

}  // namespace

template <class Real>
void stream_and_collide(Fluid<Real>& fluid)
{
  update_fluid(fluid.f, fluid.f_next, fluid, true);
  std::swap(fluid.f, fluid.f_next);
}

template <class Real>
void collide_in_place(Fluid<Real>& fluid)
{
  update_fluid(fluid.f, fluid.f, fluid, false);
}

template <class Real>
void stream(Fluid<Real>& fluid)
{
  int const nx = fluid.nx, ny = fluid.ny;
  auto const from = fluid.f, to = fluid.f_next;
  Kokkos::parallel_for(
      "velum::lbm::stream", Kokkos::RangePolicy<Space>(0, 9 * ny), KOKKOS_LAMBDA(int k) {
        int const i = k / ny, j = k % ny;
        for (int x = 0; x < nx; ++x)
          to(i, j + 1, x + 1) = from(i, j + 1 - D2Q9::cy(i), x + 1 - D2Q9::cx(i));
      });
  std::swap(fluid.f, fluid.f_next);
}

template <class Real>
void fill_ghosts(Fluid<Real>& fluid)
{
  int const nx = fluid.nx, ny = fluid.ny;
  auto const f = fluid.f;
  bool const axis = fluid.has_axis();
  if (fluid.model.periodic_x)
    Kokkos::parallel_for(
        "velum::lbm::fill_columns", Kokkos::RangePolicy<Space>(0, ny + 2), KOKKOS_LAMBDA(int j) {
          for (int i = 0; i < 9; ++i) {
            f(i, j, 0) = f(i, j, nx);
            f(i, j, nx + 1) = f(i, j, 1);
          }
        });
  if (axis || fluid.model.periodic_y)
    Kokkos::parallel_for(
        "velum::lbm::fill_rows", Kokkos::RangePolicy<Space>(0, nx + 2), KOKKOS_LAMBDA(int x) {
          for (int i = 0; i < 9; ++i) {
            f(i, 0, x) = axis ? f(D2Q9::mirrored_in_axis(i), 1, x) : f(i, ny, x);
            if (!axis) f(i, ny + 1, x) = f(i, 1, x);
          }
        });
}

template void stream_and_collide(Fluid<float>&);
template void stream_and_collide(Fluid<double>&);
template void collide_in_place(Fluid<float>&);
template void collide_in_place(Fluid<double>&);
template void stream(Fluid<float>&);
template void stream(Fluid<double>&);
template void fill_ghosts(Fluid<float>&);
template void fill_ghosts(Fluid<double>&);

}  // namespace velum::lbm
