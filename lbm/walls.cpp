#include "lbm/walls.hpp"

namespace velum::lbm {

namespace {

/// Share of the way from a (fluid) to b (wall) at which the distance changes sign.
double crossing(core::Obstacle const& solids, core::Vec2 a, core::Vec2 b)
{
  double lo = 0, hi = 1;
  for (int k = 0; k < 50; ++k) {
    double const mid = (lo + hi) / 2;
    (core::distance(solids, a + mid * (b - a)) > 0 ? lo : hi) = mid;
  }
  return (lo + hi) / 2;
}

}  // namespace

template <class Real>
Neighbour neighbour(Fluid<Real> const& fluid, int i, int j, int dir)
{
  int x = i + D2Q9::cx(dir), y = j + D2Q9::cy(dir);
  if (fluid.model.periodic_x) x = (x + fluid.nx) % fluid.nx;
  if (fluid.model.periodic_y) y = (y + fluid.ny) % fluid.ny;
  if (y == -1 && fluid.has_axis()) y = 0;
  if (x < 0 || x >= fluid.nx || y < 0 || y >= fluid.ny) return {-1, -1};
  return {x, y};
}

template <class Real>
Walls find_walls(Fluid<Real> const& fluid, core::Obstacle const& solids)
{
  Walls walls;
  walls.nx = fluid.nx;
  walls.ny = fluid.ny;
  auto const cells = static_cast<std::size_t>(fluid.nx) * static_cast<std::size_t>(fluid.ny);
  walls.solid.resize(cells);
  walls.distance.resize(cells);
  auto const centre = [&](int i, int j) { return fluid.origin + core::Vec2{i + 0.5, j + 0.5}; };
  for (int j = 0, c = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i, ++c) {
      auto const k = static_cast<std::size_t>(c);
      walls.distance[k] = core::distance(solids, centre(i, j));
      walls.solid[k] = walls.distance[k] <= 0;
    }
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i) {
      if (walls.is_solid(i, j)) continue;
      core::Vec2 const a = centre(i, j);
      for (int dir = 1; dir < D2Q9::Q; ++dir) {
        Neighbour const n = neighbour(fluid, i, j, dir);
        bool const box = n.i < 0;
        if (!box && !walls.is_solid(n.i, n.j)) continue;
        core::Vec2 const c = {double(D2Q9::cx(dir)), double(D2Q9::cy(dir))};
        // A link that leaves the box meets its side half-way, or a solid before that.
        double q = 0.5;
        bool side = box;
        if (!box) q = crossing(solids, a, a + c);
        if (box && core::distance(solids, a + 0.5 * c) <= 0) {
          q = 0.5 * crossing(solids, a, a + 0.5 * c);
          side = false;
        }
        walls.hits.push_back({i, j, dir, q > 1e-9 ? q : 1e-9, a + q * c, side});
      }
    }
  return walls;
}

template <class Real>
Link link_at(Fluid<Real> const& fluid, Walls const& walls, WallHit const& hit, double weight)
{
  Neighbour const behind = neighbour(fluid, hit.i, hit.j, D2Q9::opposite(hit.dir));
  bool const second = behind.i >= 0 && !walls.is_solid(behind.i, behind.j);
  return {hit.i, hit.j, std::int16_t(hit.dir), std::int16_t(second), float(weight), hit.q};
}

template <class Real>
void deactivate_solids(Fluid<Real>& fluid, Walls const& walls)
{
  auto const active_host = Kokkos::create_mirror_view(fluid.active);
  for (int j = 0; j < fluid.ny; ++j)
    for (int i = 0; i < fluid.nx; ++i) active_host(j + 1, i + 1) = !walls.is_solid(i, j);
  Kokkos::deep_copy(fluid.active, active_host);
}

template Neighbour neighbour(Fluid<float> const&, int, int, int);
template Neighbour neighbour(Fluid<double> const&, int, int, int);
template Walls find_walls(Fluid<float> const&, core::Obstacle const&);
template Walls find_walls(Fluid<double> const&, core::Obstacle const&);
template Link link_at(Fluid<float> const&, Walls const&, WallHit const&, double);
template Link link_at(Fluid<double> const&, Walls const&, WallHit const&, double);
template void deactivate_solids(Fluid<float>&, Walls const&);
template void deactivate_solids(Fluid<double>&, Walls const&);

}  // namespace velum::lbm
