#include "core/host_access.hpp"
#include "core/static_for.hpp"
#include "lbm/formats.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::lbm {

namespace {

/// What lies beyond the sides of the box: along each axis its own other end, images, or a wall.
struct Sides {
  int size[3];
  bool periodic[3], low_mirror[3], high_mirror[3];

  bool are_open(int axis) const { return periodic[axis] || low_mirror[axis] || high_mirror[axis]; }
};

template <class Real, class L, class Stored>
Sides sides_of(Fluid<Real, L, Stored> const& fluid)
{
  Sides sides{{fluid.nx, fluid.ny, fluid.nz}, {}, {}, {}};
  for (int a = 0; a < L::D; ++a) {
    sides.periodic[a] = fluid.model.periodic(a);
    sides.low_mirror[a] =
        (fluid.model.mirrors & mirror(a, false)) != 0 || (a == 1 && fluid.has_axis());
    sides.high_mirror[a] = (fluid.model.mirrors & mirror(a, true)) != 0;
  }
  return sides;
}

/// A step across a side of the box along one axis: where it comes from, and whether as an image.
struct Source {
  int at;
  bool image;
  bool wall;  // neither periodic nor a mirror: nothing to do here
};

KOKKOS_INLINE_FUNCTION Source source(Sides const& s, int axis, int at)
{
  int const size = s.size[axis];
  if (at >= 0 && at < size) return {at, false, false};
  if (s.periodic[axis]) return {at < 0 ? at + size : at - size, false, false};
  bool const image = at < 0 ? s.low_mirror[axis] : s.high_mirror[axis];
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

/// The cell of a layer across an axis, by its two other coordinates in the order x, y, z.
struct Place {
  int c[3];

  KOKKOS_INLINE_FUNCTION Place(int axis, int layer, int first, int second)
  {
    for (int a = 0, k = 0; a < 3; ++a) c[a] = a == axis ? layer : k++ == 0 ? first : second;
  }
};

/// Brings what comes in to one cell of a layer through its side, whatever other sides it touches.
template <class Real, class L, class Stored>
KOKKOS_INLINE_FUNCTION void fill_cell(Fluid<Real, L, Stored> const& to, Sides const& s, int axis,
                                      int inwards, Place const& p)
{
  int const cell = to.cell(p.c[0], p.c[1], p.c[2]);
  core::static_for<L::Q>([&](auto direction) __attribute__((always_inline)) {
    constexpr int d = direction;
    // through a layer that is both ends of the box something comes in from both
    bool const in = s.size[axis] == 1 ? L::c(d, axis) != 0 : L::c(d, axis) == inwards;
    if (!in) return;
    Source from[3] = {};
    int planes = 0;
    bool wall = false, across = false;
    for (int a = 0; a < L::D; ++a) {
      from[a] = source(s, a, p.c[a] - L::c(d, a));
      wall = wall || from[a].wall;
      across = across || from[a].at != p.c[a] - L::c(d, a);
      planes |= (from[a].image ? 1 : 0) << a;
    }
    if (wall || !across) return;
    constexpr Images<L> images(d);
    to.f.set_arriving(
        d, cell, to.f.outgoing(images.of[planes], to.cell(from[0].at, from[1].at, from[2].at)));
  });
}

/// The cells of a layer that touch other sides too; `whole` takes all of it.
template <class Real, class L, class Stored>
void fill_rim(Fluid<Real, L, Stored> const& to, Sides const& s, int axis, int layer, int inwards,
              bool whole)
{
  int const first = s.size[axis == 0 ? 1 : 0], second = L::D == 3 ? s.size[axis == 2 ? 1 : 2] : 1;
  int const count = whole ? first * second : L::D == 3 ? 2 * (first + second) : 2;
  Kokkos::parallel_for(
      "velum::lbm::fill_rim", count, KOKKOS_LAMBDA(int n) {
        int a = n % first, b = n / first;
        if (!whole && L::D == 2) {
          a = n == 0 ? 0 : first - 1;
          b = 0;
        } else if (!whole && b < 2) {
          b = b == 0 ? 0 : second - 1;
        } else if (!whole) {
          int const m = n - 2 * first;
          a = m < second ? 0 : first - 1;
          b = m % second;
        }
        fill_cell(to, s, axis, inwards, Place(axis, layer, a, b));
      });
}

/// Numbers to copy from one line of cells to another.
template <class Stored>
struct Line {
  Stored* to;
  Stored const* from;
  int stride;

  KOKKOS_FORCEINLINE_FUNCTION void copy(int k) const { to[k * stride] = from[k * stride]; }
};

/// The cells of a layer that touch no other side, as lines for each direction that comes in: all of
/// a line comes from the same distance, and stored numbers are copied as they are, for a direction
/// and its image have the same weight.
template <class Real, class L, class Stored>
struct Layer {
  Fluid<Real, L, Stored> fluid;
  int axis, at, inwards;
  Source beyond;
  int directions = 0, direction[9] = {};
  int length, lines;

  Layer(Fluid<Real, L, Stored> const& of, Sides const& s, int across, int layer, int in)
      : fluid(of), axis(across), at(layer), inwards(in), beyond(source(s, across, layer - in))
  {
    for (int d = 1; d < L::Q; ++d)
      if (L::c(d, axis) == inwards) direction[directions++] = d;
    length = s.size[axis == 0 ? 1 : 0] - 2;
    lines = L::D == 3 ? s.size[axis == 2 ? 1 : 2] - 2 : 1;
  }

  KOKKOS_FORCEINLINE_FUNCTION Line<Stored> line(int n) const
  {
    auto const& f = fluid.f;
    int const d = direction[n % directions], row = n / directions + (L::D == 3 ? 1 : 0);
    int const from = beyond.image ? mirrored<L>(d, axis) : d;
    Place const p(axis, at, 1, row);
    int source_at[3] = {0, 0, 0};
    for (int a = 0; a < L::D; ++a) source_at[a] = a == axis ? beyond.at : p.c[a] - L::c(d, a);
    int const cell = fluid.cell(p.c[0], p.c[1], p.c[2]);
    int const left = fluid.cell(source_at[0], source_at[1], source_at[2]);
    return {f.turned() ? &f.slots(L::opposite(d), cell - f.shift(d)) : &f.slots(d, cell),
            f.turned() ? &f.slots(L::opposite(from), left) : &f.slots(from, left + f.shift(from)),
            axis == 0 ? f.pitch : 1};
  }
};

template <class Real, class L, class Stored>
void fill_inside(Layer<Real, L, Stored> const& layer)
{
  if (layer.length < 1 || layer.lines < 1) return;
  int const count = layer.lines * layer.directions, length = layer.length;
  if constexpr (core::on_host) {
    Kokkos::parallel_for(
        "velum::lbm::fill_lines", count, KOKKOS_LAMBDA(int n) {
          auto const line = layer.line(n);
          for (int k = 0; k < length; ++k) line.copy(k);
        });
  } else {
    using Team = Kokkos::TeamPolicy<>;
    Kokkos::parallel_for(
        "velum::lbm::fill_lines", Team(count, Kokkos::AUTO),
        KOKKOS_LAMBDA(typename Team::member_type const& team) {
          auto const line = layer.line(team.league_rank());
          Kokkos::parallel_for(Kokkos::TeamThreadRange(team, length), [&](int k) { line.copy(k); });
        });
  }
}

}  // namespace

template <class Real, class L, class Stored>
void fill_ghosts(Fluid<Real, L, Stored>& fluid)
{
  Fluid<Real, L, Stored> const to = fluid;
  Sides const s = sides_of(fluid);
  for (int axis = 0; axis < L::D; ++axis) {
    if (!s.are_open(axis)) continue;
    bool const thin = s.size[axis] == 1;  // both ends at once
    for (bool const upper : {false, true}) {
      if (thin && upper) continue;
      int const inwards = upper ? -1 : 1, at = upper ? s.size[axis] - 1 : 0;
      fill_rim(to, s, axis, at, inwards, thin);
      Layer<Real, L, Stored> const layer(to, s, axis, at, inwards);
      if (!thin && !layer.beyond.wall) fill_inside(layer);
    }
  }
}

#define VELUM_INSTANTIATE(Real, L, Stored) template void fill_ghosts(Fluid<Real, L, Stored>&);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
