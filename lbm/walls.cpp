#include "lbm/walls.hpp"

#include "lbm/formats.hpp"

namespace velum::lbm {

namespace {

template <class L>
using Point = core::Vec<double, L::D>;

template <class L>
Point<L> direction(int dir)
{
  Point<L> c;
  for (int a = 0; a < L::D; ++a) c[a] = L::c(dir, a);
  return c;
}

/// Share of the way from a (fluid) along c (to a wall) at which the distance changes sign.
template <class L>
double crossing(core::SignedDistance<L::D> const& solids, Point<L> const& a, Point<L> const& c)
{
  double lo = 0, hi = 1;
  for (int n = 0; n < 50; ++n) {
    double const mid = (lo + hi) / 2;
    (solids(a + mid * c) > 0 ? lo : hi) = mid;
  }
  return (lo + hi) / 2;
}

/// One component of neighbour(): the index along an axis, -1 outside.
template <class Real, class L, class Stored>
int along_axis(Fluid<Real, L, Stored> const& fluid, int axis, int at, int size)
{
  if (at >= 0 && at < size) return at;
  if (fluid.model.periodic(axis)) return (at + size) % size;
  bool const upper = at >= size;
  if ((fluid.model.mirrors & mirror(axis, upper)) != 0 || (axis == 1 && !upper && fluid.has_axis()))
    return upper ? size - 1 : 0;
  return -1;
}

}  // namespace

template <class Real, class L, class Stored>
Neighbour neighbour(Fluid<Real, L, Stored> const& fluid, int i, int j, int dir, int k)
{
  int const x = along_axis(fluid, 0, i + L::c(dir, 0), fluid.nx);
  int const y = along_axis(fluid, 1, j + L::c(dir, 1), fluid.ny);
  int const z = L::D == 3 ? along_axis(fluid, 2, k + L::c(dir, L::D - 1), fluid.nz) : 0;
  if (x < 0 || y < 0 || z < 0) return {-1, -1, -1};
  return {x, y, z};
}

template <class Real, class L, class Stored>
Behind behind(Fluid<Real, L, Stored> const& fluid, Neighbour const& cell, int dir)
{
  int const against = L::opposite(dir);
  int const at[] = {cell.i, cell.j, cell.k}, size[] = {fluid.nx, fluid.ny, fluid.nz};
  int turned[3] = {};
  for (int a = 0; a < L::D; ++a) {
    int const next = at[a] + L::c(against, a);
    bool const image = (next < 0 || next >= size[a]) && !fluid.model.periodic(a);
    turned[a] = image ? -L::c(dir, a) : L::c(dir, a);
  }
  int there = 0;
  for (int d = 0; d < L::Q; ++d)
    if (L::c(d, 0) == turned[0] && L::c(d, 1) == turned[1] &&
        (L::D == 2 || L::c(d, L::D - 1) == turned[2]))
      there = d;
  return {neighbour(fluid, cell.i, cell.j, against, cell.k), there};
}

template <class Real, class L, class Stored>
Walls find_walls(Fluid<Real, L, Stored> const& fluid,
                 std::type_identity_t<core::SignedDistance<L::D>> const& solids)
{
  Walls walls;
  walls.nx = fluid.nx;
  walls.ny = fluid.ny;
  walls.nz = fluid.nz;
  walls.solid.resize(static_cast<std::size_t>(fluid.cells()));
  walls.distance.resize(walls.solid.size());
  auto const centre = [&](int i, int j, int k) {
    Point<L> p = fluid.origin;
    int const at[3] = {i, j, k};
    for (int a = 0; a < L::D; ++a) p[a] += at[a] + 0.5;
    return p;
  };
  auto const each_cell = [&](auto const& visit) {
    for (int k = 0; k < fluid.nz; ++k)
      for (int j = 0; j < fluid.ny; ++j)
        for (int i = 0; i < fluid.nx; ++i) visit(i, j, k);
  };
  each_cell([&](int i, int j, int k) {
    std::size_t const n = walls.index(i, j, k);
    walls.distance[n] = solids(centre(i, j, k));
    walls.solid[n] = walls.distance[n] <= 0;
  });
  each_cell([&](int i, int j, int k) {
    if (walls.is_solid(i, j, k)) return;
    Point<L> const a = centre(i, j, k);
    for (int dir = 1; dir < L::Q; ++dir) {
      Neighbour const n = neighbour(fluid, i, j, dir, k);
      bool const box = n.i < 0;
      if (!box && !walls.is_solid(n.i, n.j, n.k)) continue;
      Point<L> const c = direction<L>(dir);
      // A link that leaves the box meets its side half-way, or a solid before that.
      double q = 0.5;
      bool side = box;
      if (!box) q = crossing<L>(solids, a, c);
      if (box && solids(a + 0.5 * c) <= 0) {
        q = 0.5 * crossing<L>(solids, a, 0.5 * c);
        side = false;
      }
      Point<L> const at = a + q * c;
      core::Vec3 place;
      for (int d = 0; d < L::D; ++d) place[d] = at[d];
      walls.hits.push_back({i, j, dir, q > 1e-9 ? q : 1e-9, place, side, k});
    }
  });
  return walls;
}

template <class Real, class L, class Stored>
void deactivate_solids(Fluid<Real, L, Stored>& fluid, Walls const& walls)
{
  std::vector<std::uint8_t> mask(walls.solid.size());
  for (std::size_t c = 0; c < mask.size(); ++c) mask[c] = walls.solid[c] ? 0 : 1;
  mark(fluid, mask);
}

template <class Real, class L, class Stored>
Link link_at(Fluid<Real, L, Stored> const& fluid, Walls const& walls, WallHit const& hit,
             double weight)
{
  double const q = fluid.model.wall_rule == WallRule::half_way ? 0.5 : hit.q;
  Link l{hit.i, hit.j, std::int16_t(hit.dir), Stencil::half_way, float(weight), q, hit.k};
  set_stencil(fluid, l, [&](Neighbour const& n) { return !walls.is_solid(n.i, n.j, n.k); });
  return l;
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                                     \
  template Neighbour neighbour(Fluid<Real, L, Stored> const&, int, int, int, int);             \
  template Behind behind(Fluid<Real, L, Stored> const&, Neighbour const&, int);                \
  template Walls find_walls(Fluid<Real, L, Stored> const&, core::SignedDistance<L::D> const&); \
  template void deactivate_solids(Fluid<Real, L, Stored>&, Walls const&);                      \
  template Link link_at(Fluid<Real, L, Stored> const&, Walls const&, WallHit const&, double);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::lbm
