#include "core/static_for.hpp"
#include "lbm/formats.hpp"
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

/// Images of a direction in the planes across any of the axes: bit a of the place for axis a.
template <class L>
struct Images {
  int of[8];

  constexpr explicit Images(int d) : of{}
  {
    for (int planes = 0; planes < 8; ++planes) {
      of[planes] = d;
      for (int a = 0; a < L::D; ++a)
        if (planes >> a & 1) of[planes] = mirrored<L>(of[planes], a);
    }
  }
};

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
    // each time the same, and a layer of a box one cell thick is both
    int const across = axis == 0 ? n1 * n2 : axis == 1 ? n0 * n2 : n0 * n1;
    int const last = size[axis] - 1, size_along = size[axis];
    Kokkos::parallel_for(
        "velum::lbm::fill_ghosts", 2 * across, KOKKOS_LAMBDA(int n) {
          int const layer = n < across ? 0 : last, m = n % across;
          int const i = axis == 0 ? layer : m % n0;
          int const j = axis == 1 ? layer : axis == 0 ? m % n1 : m / n0;
          int const k = axis == 2 ? layer : axis == 0 ? m / n1 : m / n0;
          int const z = axis == 1 ? m / n0 : k;
          int const cell = to.cell(i, j, z);
          bool const single = size_along == 1;
          core::static_for<L::Q>([&](auto direction) __attribute__((always_inline)) {
            constexpr int d = direction;
            constexpr int cx = L::c(d, 0), cy = L::c(d, 1), cz = L::D == 3 ? L::c(d, L::D - 1) : 0;
            int const inwards = axis == 0 ? cx : axis == 1 ? cy : cz;
            // only what comes in through this side
            if (inwards == 0 || (!single && inwards != (n < across ? 1 : -1))) return;
            Source const x = source(i - cx, n0, p0, l0, h0);
            Source const y = source(j - cy, n1, p1, l1, h1);
            Source const w = source(z - cz, n2, p2, l2, h2);
            if (x.wall || y.wall || w.wall) return;
            if (x.at == i - cx && y.at == j - cy && w.at == z - cz) return;
            constexpr Images<L> images(d);
            int const from = images.of[(x.image ? 1 : 0) + (y.image ? 2 : 0) + (w.image ? 4 : 0)];
            to.f.set_arriving(d, cell, to.f.outgoing(from, to.cell(x.at, y.at, w.at)));
          });
        });
  }
}

#define VELUM_INSTANTIATE(Real, L, Stored) template void fill_ghosts(Fluid<Real, L, Stored>&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
