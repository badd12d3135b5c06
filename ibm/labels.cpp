#include "ibm/labels.hpp"

#include <algorithm>
#include <cmath>

namespace velum::ibm {

namespace {

/// Adds, row by row, the first site at or above each crossing of the face with the row.
void cross_rows(FaceLine const& face, Labels const& labels, std::vector<std::vector<int>>& rows)
{
  for (auto& row : rows) row.clear();
  for (std::size_t s = 0; s + 1 < face.points.size(); ++s) {
    core::Vec2 const a = face.points[s] - labels.origin, b = face.points[s + 1] - labels.origin;
    double const lo = std::min(a[1], b[1]), hi = std::max(a[1], b[1]);
    int const first = std::max(0, static_cast<int>(std::ceil(std::max(lo, 0.0) - 0.5)));
    int const last = static_cast<int>(std::min<double>(labels.ny - 1, std::floor(hi - 0.5)));
    for (int j = first; j <= last; ++j) {
      double const y = j + 0.5;
      if ((a[1] <= y) == (b[1] <= y)) continue;
      double const x = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
      double const site = std::ceil(x - 0.5);
      rows[static_cast<std::size_t>(j)].push_back(
          static_cast<int>(std::clamp(site, -1.0, labels.nx + 1.0)));
    }
  }
  for (auto& row : rows) std::sort(row.begin(), row.end());
}

/// Whether an odd number of crossings lies above site i.
bool is_below(std::vector<int> const& row, int i)
{
  return (row.end() - std::upper_bound(row.begin(), row.end(), i)) % 2 != 0;
}

}  // namespace

Labels make_labels(int nx, int ny, core::Vec2 origin)
{
  Labels labels;
  labels.nx = nx;
  labels.ny = ny;
  labels.origin = origin;
  labels.plus.resize(static_cast<std::size_t>(ny));
  labels.minus.resize(static_cast<std::size_t>(ny));
  labels.side.assign(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), 0);
  return labels;
}

bool classify(Labels& labels, Surface const& surface)
{
  thread_local std::vector<std::vector<int>> plus, minus;
  plus.resize(labels.plus.size());
  minus.resize(labels.minus.size());
  cross_rows(surface.plus, labels, plus);
  cross_rows(surface.minus, labels, minus);
  bool changed = false;
  for (int j = 0; j < labels.ny; ++j) {
    auto const row = static_cast<std::size_t>(j);
    bool const unlabelled = labels.side[row * static_cast<std::size_t>(labels.nx)] == 0;
    if (!unlabelled && plus[row] == labels.plus[row] && minus[row] == labels.minus[row]) continue;
    changed = true;
    labels.plus[row] = plus[row];
    labels.minus[row] = minus[row];
    for (int i = 0; i < labels.nx; ++i)
      labels.side[static_cast<std::size_t>(j * labels.nx + i)] = !is_below(plus[row], i) ? plus_side
                                                                 : is_below(minus[row], i)
                                                                     ? minus_side
                                                                     : inside;
  }
  return changed;
}

}  // namespace velum::ibm
