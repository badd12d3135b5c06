#include "ibm/sharp_links.hpp"

#include <algorithm>
#include <cmath>

namespace velum::ibm {

namespace {

using lbm::D2Q9;

template <class Real>
void place_wall(Sharp<Real> const& body, lbm::Fluid<Real> const& fluid, lbm::Link& l, double q)
{
  l.q = fluid.model.wall_rule == lbm::WallRule::half_way ? 0.5 : q;
  lbm::set_stencil(fluid, l, [&](lbm::Neighbour const& n) {
    return body.cells.at(n.i, n.j) == body.cells.at(l.i, l.j);
  });
}

template <class Real>
lbm::Link link(Sharp<Real> const& body, lbm::Fluid<Real> const& fluid, int i, int j, int dir,
               double q)
{
  lbm::Link l{i, j, std::int16_t(dir), lbm::Stencil::half_way, 1.0f, 0};
  l.region = body.mass.regions.of[static_cast<std::size_t>(j * body.cells.labels.nx + i)];
  place_wall(body, fluid, l, q);
  return l;
}

template <class Real>
Hit find_hit(Sharp<Real> const& body, int i, int j, int dir)
{
  Cells const& cells = body.cells;
  core::Vec2 const p = cells.labels.origin + core::Vec2{i + 0.5, j + 0.5};
  core::Vec2 const c = {double(D2Q9::cx(dir)), double(D2Q9::cy(dir))};
  return cells.at(i, j) == fluid_plus ? cut(body.surface.plus, cells.plus_index, p, c)
                                      : cut(body.surface.minus, cells.minus_index, p, c);
}

template <class Real>
void add_cut(Sharp<Real>& body, lbm::Fluid<Real> const& fluid, int i, int j, int dir,
             Hit const& hit)
{
  double const y = fluid.origin[1] + j + 0.5;
  std::uint8_t const side = body.cells.at(i, j);
  body.cut_host.push_back(link(body, fluid, i, j, dir, hit.q));
  body.cut.push_back({hit, lbm::link_ring(fluid.symmetry, y, dir), side,
                      side == fluid_minus && y < body.divide,
                      fluid.model.wall_rule == lbm::WallRule::half_way});
}

/// Sites of row j that may have a neighbour across the membrane, or in the gap below it: from two,
/// and the width of the gap, below the lowest crossing of this row and its neighbours to two above
/// the highest.
struct Band {
  int first, last;
};
Band band(Labels const& labels, double gap_width, int j)
{
  int const below = 2 + static_cast<int>(std::ceil(gap_width > 0 ? gap_width + 1 : 0));
  Band b{labels.nx, -1};
  for (int r = std::max(0, j - 1); r <= std::min(labels.ny - 1, j + 1); ++r)
    for (auto const* rows : {&labels.plus, &labels.minus})
      for (int site : (*rows)[static_cast<std::size_t>(r)]) {
        b.first = std::min(b.first, site - below);
        b.last = std::max(b.last, site + 2);
      }
  return {std::max(b.first, 0), std::min(b.last, labels.nx - 1)};
}

/// Side of the wall site that a link leads to. Where it is not the fluid cell's own, the membrane
/// is what the link meets: it must feel the load even where it is pressed a little into the wall,
/// and a face that slides along a wall must displace the full width of its last cell. Beyond the
/// box the membrane goes on as in the last row, which makes the area of its links exactly the
/// section's.
template <class Real>
std::uint8_t label_beyond(Sharp<Real> const& body, lbm::Fluid<Real> const& fluid,
                          lbm::WallHit const& h)
{
  auto const n = lbm::neighbour(fluid, h.i, h.j, h.dir);
  if (n.i >= 0) return body.cells.labels.at(n.i, n.j);
  int const i = std::clamp(h.i + D2Q9::cx(h.dir), 0, fluid.nx - 1);
  return body.cells.labels.at(i, h.j);
}

template <class Real>
void mark_active(Sharp<Real> const& body, lbm::Fluid<Real>& fluid)
{
  std::vector<std::uint8_t> mask = body.cells.state;
  for (std::uint8_t& s : mask)
    if (!is_fluid(s)) s = 0;
  lbm::mark(fluid, mask);
}

/// A cell is in the wedge where wall and membrane meet when both are touched within this many
/// cells.
constexpr int wedge_reach = 4;

/// In such a wedge both reflect half-way: where both are interpolated the corner answers itself,
/// and at low viscosity its answer grows. Walls that are half-way by their place do no harm.
template <class Real>
void round_wedges(Sharp<Real>& body, std::vector<lbm::Link>& resting)
{
  std::vector<std::uint8_t> touches(body.cells.state.size(), 0);
  auto const cell = [&](lbm::Link const& l) -> std::uint8_t& {
    return touches[static_cast<std::size_t>(l.j * body.cells.labels.nx + l.i)];
  };
  for (lbm::Link const& l : body.cut_host) cell(l) |= 1;
  for (lbm::Link const& l : resting)
    if (l.q != 0.5) cell(l) |= 2;
  auto const half_way = [](lbm::Link& l) {
    l.q = 0.5;
    l.stencil = lbm::Stencil::half_way;
  };
  int const nx = body.cells.labels.nx, ny = body.cells.labels.ny;
  auto const in_wedge = [&](lbm::Link const& l) {
    std::uint8_t seen = 0;
    for (int j = std::max(0, l.j - wedge_reach); j <= std::min(ny - 1, l.j + wedge_reach); ++j)
      for (int i = std::max(0, l.i - wedge_reach); i <= std::min(nx - 1, l.i + wedge_reach); ++i)
        seen |= touches[static_cast<std::size_t>(j * nx + i)];
    return seen == 3;
  };
  for (lbm::Link& l : resting)
    if (in_wedge(l)) half_way(l);
  for (std::size_t k = 0; k < body.cut.size(); ++k) {
    body.cut[k].half_way |= in_wedge(body.cut_host[k]);
    if (body.cut[k].half_way) half_way(body.cut_host[k]);
  }
}

template <class Real>
void upload_cuts(Sharp<Real>& body)
{
  lbm::upload(body.cut_links, body.cut_host);
  if (body.wall_term.extent(0) >= body.cut_host.size()) return;
  std::size_t const room = body.cut_host.size() * 5 / 4 + 64;
  body.wall_term = Kokkos::View<double*>("wall_term", room);
  body.heard = Kokkos::View<double**, Kokkos::LayoutRight>("heard", 3, room);
}

}  // namespace

template <class Real>
void rebuild_links(Sharp<Real>& body, lbm::Fluid<Real>& fluid)
{
  Cells const& cells = body.cells;
  find_regions(body.mass, fluid, cells);
  body.cut.clear();
  body.cut_host.clear();
  std::vector<lbm::Link> resting, edge[2];
  for (lbm::WallHit const& h : body.wall_hits) {
    if (!is_fluid(cells.at(h.i, h.j))) continue;
    if (label_beyond(body, fluid, h) != cells.labels.at(h.i, h.j)) {
      Hit const hit = find_hit(body, h.i, h.j, h.dir);
      if (hit.found) {
        add_cut(body, fluid, h.i, h.j, h.dir, hit);
        continue;
      }
    }
    resting.push_back(link(body, fluid, h.i, h.j, h.dir, h.q));
  }
  for (int j = 0; j < fluid.ny; ++j) {
    Band const b = band(cells.labels, cells.gap_width, j);
    for (int i = b.first; i <= b.last; ++i) {
      std::uint8_t const own = cells.at(i, j);
      if (!is_fluid(own)) continue;
      for (int dir = 1; dir < D2Q9::Q; ++dir) {
        auto const n = lbm::neighbour(fluid, i, j, dir);
        if (n.i < 0) continue;
        std::uint8_t const other = cells.at(n.i, n.j);
        if (other == own || other == wall) continue;
        bool const same_label = cells.labels.at(n.i, n.j) == cells.labels.at(i, j);
        if (other == gap && same_label)
          edge[fluid.origin[1] + j + 0.5 < body.divide ? 1 : 0].push_back(
              link(body, fluid, i, j, dir, 0.5));
        else if (other == film && same_label)
          resting.push_back(link(body, fluid, i, j, dir, 0.5));
        else
          add_cut(body, fluid, i, j, dir, find_hit(body, i, j, dir));
      }
    }
  }
  round_wedges(body, resting);
  lbm::upload(body.resting, resting);
  for (int side : {0, 1}) {
    body.gap_area[side] = 0;
    for (lbm::Link const& l : edge[side])
      body.gap_area[side] += (side == 0 ? -1 : 1) * 6 * D2Q9::w(l.dir) * D2Q9::cy(l.dir) *
                             lbm::link_ring(fluid.symmetry, fluid.origin[1] + l.j + 0.5, l.dir);
    lbm::upload(body.gap_edge[side], edge[side]);
  }
  upload_cuts(body);
  mark_active(body, fluid);
}

template <class Real>
void recut(Sharp<Real>& body, lbm::Fluid<Real> const& fluid)
{
  for (std::size_t k = 0; k < body.cut.size(); ++k) {
    lbm::Link& l = body.cut_host[k];
    body.cut[k].hit = find_hit(body, l.i, l.j, l.dir);
    if (!body.cut[k].half_way) place_wall(body, fluid, l, body.cut[k].hit.q);
  }
  upload_cuts(body);
}

template <class Real>
double seat_crossing(Sharp<Real> const& body, lbm::Fluid<Real> const& fluid)
{
  double const edge = body.divide - fluid.origin[1];
  if (edge < 0.5 || edge > fluid.ny - 0.5) return 0;  // no seat in the box
  int const row = std::min(static_cast<int>(std::lround(edge)), fluid.ny - 1);
  lbm::Fluid<Real> const from = fluid;
  int const nx = fluid.nx;
  double const ring = core::ring(fluid.symmetry, fluid.origin[1] + row);
  double sum = 0;
  Kokkos::parallel_reduce(
      "velum::ibm::seat_crossing", nx,
      KOKKOS_LAMBDA(int i, double& mass) {
        int const cell = from.cell(i, row);
        if (from.active(cell) != fluid_minus) return;
        for (int d = 1; d < D2Q9::Q; ++d) {
          if (D2Q9::cy(d) != -1) continue;
          int const x = i + D2Q9::cx(d);
          int const below = from.cell(x, row - 1);
          if (x < 0 || x >= nx || from.active(below) != fluid_minus) continue;
          mass +=
              double(from.f.outgoing(d, cell)) - double(from.f.outgoing(D2Q9::opposite(d), below));
        }
      },
      sum);
  return ring * sum;
}

template void rebuild_links(Sharp<float>&, lbm::Fluid<float>&);
template void rebuild_links(Sharp<double>&, lbm::Fluid<double>&);
template void recut(Sharp<float>&, lbm::Fluid<float> const&);
template void recut(Sharp<double>&, lbm::Fluid<double> const&);
template double seat_crossing(Sharp<float> const&, lbm::Fluid<float> const&);
template double seat_crossing(Sharp<double> const&, lbm::Fluid<double> const&);

}  // namespace velum::ibm
