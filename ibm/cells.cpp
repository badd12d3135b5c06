#include "ibm/cells.hpp"

#include <algorithm>
#include <limits>

namespace velum::ibm {

namespace {

/// Axial place of the face where it is lowest, without its continuations.
double lowest(FaceLine const& face)
{
  double x = face.points[1][0];
  for (std::size_t a = 1; a + 1 < face.points.size(); ++a) x = std::min(x, face.points[a][0]);
  return x;
}

}  // namespace

Cells make_cells(lbm::Walls const& walls, core::Vec2 origin, bool dry_plus, SeatGapCells const& gap)
{
  Cells cells;
  cells.dry_plus = dry_plus;
  cells.gap_width = gap.width;
  cells.labels = make_labels(walls.nx, walls.ny, origin);
  cells.state.assign(walls.solid.size(), wall);
  for (std::size_t k = 0; k < walls.solid.size(); ++k) {
    if (walls.solid[k]) continue;
    int const site = static_cast<int>(k), i = site % walls.nx, j = site / walls.nx;
    bool const wall = walls.distance[k] < film_opens;
    double const seat = gap.width > 0
                            ? core::distance(gap.seat, origin + core::Vec2{i + 0.5, j + 0.5})
                            : std::numeric_limits<double>::infinity();
    if (wall || seat < gap.width + gap_hysteresis) cells.near.push_back({site, wall, seat});
  }
  return cells;
}

bool update(Cells& cells, Surface const& surface, lbm::Walls const& walls)
{
  Labels& labels = cells.labels;
  auto const side = [&](std::size_t k) -> std::uint8_t {
    return cells.dry_plus && labels.side[k] == plus_side ? std::uint8_t(inside) : labels.side[k];
  };
  sort_into_rows(cells.plus_index, surface.plus, labels.origin[1], labels.ny);
  sort_into_rows(cells.minus_index, surface.minus, labels.origin[1], labels.ny);
  cells.changes.clear();
  auto const change = [&](std::size_t k, std::uint8_t to) {
    if (cells.state[k] == to) return;
    int const nx = labels.nx, i = static_cast<int>(k) % nx, j = static_cast<int>(k) / nx;
    cells.changes.push_back({i, j, cells.state[k], to});
    cells.state[k] = to;
  };
  // what the rules of film and gap change after the labels is one change, not two
  auto const change_again = [&](std::size_t k, std::uint8_t to, std::size_t by_labels) {
    int const nx = labels.nx, i = static_cast<int>(k) % nx, j = static_cast<int>(k) / nx;
    for (std::size_t c = 0; c < by_labels && cells.state[k] != to; ++c) {
      if (cells.changes[c].i != i || cells.changes[c].j != j) continue;
      cells.state[k] = cells.changes[c].after = to;
      return;
    }
    change(k, to);
  };
  auto const held = [&](std::size_t k) {  // film and gap end by their own rule below
    return (cells.state[k] == film || cells.state[k] == gap) && side(k) != inside;
  };
  if (classify(labels, surface))
    for (std::size_t k = 0; k < cells.state.size(); ++k)
      if (!walls.solid[k] && !held(k)) change(k, side(k));
  std::size_t const by_labels = cells.changes.size();
  // a site lower than this is farther from the face than any gap is wide
  double const far_below = lowest(surface.minus) - cells.gap_width - 1;
  for (auto const& [site, by_wall, seat] : cells.near) {
    auto const k = static_cast<std::size_t>(site);
    if (side(k) == inside) continue;
    core::Vec2 const p = labels.origin + core::Vec2{site % labels.nx + 0.5, site / labels.nx + 0.5};
    bool const plus = labels.side[k] == plus_side;
    if (!plus && p[0] < far_below) {
      change_again(k, side(k), by_labels);
      continue;
    }
    double const to_face = plus ? distance(surface.plus, cells.plus_index, p)
                                : distance(surface.minus, cells.minus_index, p);
    std::uint8_t const now = cells.state[k];
    std::uint8_t to = side(k);
    if (by_wall && walls.distance[k] + to_face < (now == film ? film_opens : film_closes))
      to = film;
    if (!plus && seat + to_face < cells.gap_width + (now == gap ? gap_hysteresis : 0.0)) to = gap;
    change_again(k, to, by_labels);
  }
  return !cells.changes.empty();
}

}  // namespace velum::ibm
