#include "ibm/cells.hpp"

namespace velum::ibm {

namespace {

/// Gap at a fluid site near a wall: distance to the wall plus distance to the face of its side.
double gap_at(Cells const& cells, Surface const& surface, lbm::Walls const& walls, std::size_t k)
{
  int const nx = cells.labels.nx, i = static_cast<int>(k) % nx, j = static_cast<int>(k) / nx;
  core::Vec2 const p = cells.labels.origin + core::Vec2{i + 0.5, j + 0.5};
  bool const plus = cells.labels.side[k] == plus_side;
  double const to_face = plus ? distance(surface.plus, cells.plus_index, p)
                              : distance(surface.minus, cells.minus_index, p);
  return walls.distance[k] + to_face;
}

}  // namespace

Cells make_cells(lbm::Walls const& walls, core::Vec2 origin, bool dry_plus)
{
  Cells cells;
  cells.dry_plus = dry_plus;
  cells.labels = make_labels(walls.nx, walls.ny, origin);
  cells.state.assign(walls.solid.size(), wall);
  for (std::size_t k = 0; k < walls.solid.size(); ++k)
    if (!walls.solid[k] && walls.distance[k] < film_opens)
      cells.near_wall.push_back(static_cast<int>(k));
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
  if (classify(labels, surface))
    for (std::size_t k = 0; k < cells.state.size(); ++k)
      if (!walls.solid[k] && !(cells.state[k] == film && side(k) != inside)) change(k, side(k));
  for (int site : cells.near_wall) {
    auto const k = static_cast<std::size_t>(site);
    if (side(k) == inside) continue;
    double const threshold = cells.state[k] == film ? film_opens : film_closes;
    change(k, gap_at(cells, surface, walls, k) < threshold ? std::uint8_t(film) : side(k));
  }
  return !cells.changes.empty();
}

}  // namespace velum::ibm
