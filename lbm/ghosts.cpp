#include "lbm/lattice/d3q19.hpp"
#include "lbm/lattice/d3q27.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::lbm {

namespace {

/// A step across a side of the box along one axis: where it comes from, and whether as an image.
struct Source {
  int at;
  bool image;
  bool wall;  // neither periodic nor a mirror: nothing to do here
};

KOKKOS_INLINE_FUNCTION Source source(int at, int size, bool periodic, bool low_mirror,
                                     bool high_mirror)
{
  if (at >= 0 && at < size) return {at, false, false};
  if (periodic) return {at < 0 ? at + size : at - size, false, false};
  bool const image = at < 0 ? low_mirror : high_mirror;
  return {at < 0 ? 0 : size - 1, image, !image};
}

}  // namespace

template <class Real, class L, class Stored>
void fill_ghosts(Fluid<Real, L, Stored>& fluid)
{
  Fluid<Real, L, Stored> const to = fluid;
  int const size[3] = {fluid.nx, fluid.ny, fluid.nz};
  bool periodic[3], low[3], high[3];
  bool any[3];
  for (int a = 0; a < 3; ++a) {
    periodic[a] = a < L::D && fluid.model.periodic(a);
    low[a] = (fluid.model.mirrors & mirror(a, false)) != 0 || (a == 1 && fluid.has_axis());
    high[a] = (fluid.model.mirrors & mirror(a, true)) != 0;
    any[a] = a < L::D && (periodic[a] || low[a] || high[a]);
  }
  int const n0 = size[0], n1 = size[1], n2 = size[2];
  bool const p0 = periodic[0], p1 = periodic[1], p2 = periodic[2];
  bool const l0 = low[0], l1 = low[1], l2 = low[2], h0 = high[0], h1 = high[1], h2 = high[2];
  for (int axis = 0; axis < L::D; ++axis) {
    if (!any[axis]) continue;
    // the two layers of cells along this axis; cells of several layers are written more than once,
    // each time the same
    int const across = axis == 0 ? n1 * n2 : axis == 1 ? n0 * n2 : n0 * n1;
    int const last = size[axis] - 1;
    Kokkos::parallel_for(
        "velum::lbm::fill_ghosts", 2 * across, KOKKOS_LAMBDA(int n) {
          int const layer = n < across ? 0 : last, m = n % across;
          int const i = axis == 0 ? layer : m % n0;
          int const j = axis == 1 ? layer : axis == 0 ? m % n1 : m / n0;
          int const k = axis == 2 ? layer : axis == 0 ? m / n1 : m / n0;
          int const cell = to.cell(i, j, axis == 1 ? m / n0 : k);
          int const z = axis == 1 ? m / n0 : k;
          for (int d = 1; d < L::Q; ++d) {
            Source const x = source(i - L::c(d, 0), n0, p0, l0, h0);
            Source const y = source(j - L::c(d, 1), n1, p1, l1, h1);
            Source const w =
                L::D == 3 ? source(z - L::c(d, L::D - 1), n2, p2, l2, h2) : Source{0, false, false};
            bool const inside = x.at == i - L::c(d, 0) && y.at == j - L::c(d, 1) &&
                                (L::D == 2 || w.at == z - L::c(d, L::D - 1));
            if (inside || x.wall || y.wall || w.wall) continue;
            int from = d;
            if (x.image) from = mirrored<L>(from, 0);
            if (y.image) from = mirrored<L>(from, 1);
            if (w.image) from = mirrored<L>(from, 2);
            to.f.set_arriving(d, cell, to.f.outgoing(from, to.cell(x.at, y.at, w.at)));
          }
        });
  }
}

template void fill_ghosts(Fluid<double, D2Q9, double>&);
template void fill_ghosts(Fluid<float, D2Q9, float>&);
template void fill_ghosts(Fluid<float, D2Q9, std::int16_t>&);
template void fill_ghosts(Fluid<double, D3Q19, double>&);
template void fill_ghosts(Fluid<float, D3Q19, float>&);
template void fill_ghosts(Fluid<float, D3Q19, std::int16_t>&);
template void fill_ghosts(Fluid<double, D3Q27, double>&);
template void fill_ghosts(Fluid<float, D3Q27, float>&);
template void fill_ghosts(Fluid<float, D3Q27, std::int16_t>&);

}  // namespace velum::lbm
