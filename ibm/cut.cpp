#include "ibm/cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::ibm {

namespace {

double cross(core::Vec2 const& a, core::Vec2 const& b) { return a[0] * b[1] - a[1] * b[0]; }

struct Range {
  int first, last;
};

Range rows_near(FaceIndex const& index, double y)
{
  int const rows = static_cast<int>(index.first.size());
  int const j = std::clamp(static_cast<int>(std::floor(y - index.origin_y)), 0, rows - 1);
  auto const k = static_cast<std::size_t>(j);
  return {index.first[k], index.last[k]};
}

/// Share along segment s of its point nearest to p, and the distance.
std::pair<double, double> nearest(FaceLine const& face, int s, core::Vec2 const& p)
{
  auto const k = static_cast<std::size_t>(s);
  core::Vec2 const a = face.points[k], d = face.points[k + 1] - a;
  double const t = std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
  return {t, norm(p - (a + t * d))};
}

}  // namespace

void sort_into_rows(FaceIndex& index, FaceLine const& face, double origin_y, int ny)
{
  auto const rows = static_cast<std::size_t>(ny);
  int const segments = static_cast<int>(face.points.size()) - 1;
  index.origin_y = origin_y;
  index.first.assign(rows, segments);
  index.last.assign(rows, -1);
  for (int s = 0; s < segments; ++s) {
    auto const k = static_cast<std::size_t>(s);
    double const a = face.points[k][1] - origin_y, b = face.points[k + 1][1] - origin_y;
    double const lo = std::min(a, b) - 1.6, hi = std::max(a, b) + 1.6;
    int const from = static_cast<int>(std::clamp(std::floor(lo), 0.0, double(ny - 1)));
    int const to = static_cast<int>(std::clamp(std::floor(hi), 0.0, double(ny - 1)));
    for (int j = from; j <= to; ++j) {
      auto const row = static_cast<std::size_t>(j);
      index.first[row] = std::min(index.first[row], s);
      index.last[row] = std::max(index.last[row], s);
    }
  }
}

Hit cut(FaceLine const& face, FaceIndex const& index, core::Vec2 p, core::Vec2 c)
{
  Hit hit;
  Range const range = rows_near(index, p[1]);
  double best = std::numeric_limits<double>::infinity();
  for (int s = range.first; s <= range.last; ++s) {
    auto const k = static_cast<std::size_t>(s);
    core::Vec2 const a = face.points[k], d = face.points[k + 1] - a;
    double const across = cross(c, d);
    if (across == 0) continue;
    double const q = cross(a - p, d) / across, t = cross(a - p, c) / across;
    if (q < 0 || q > 1 || t < 0 || t > 1 || q >= best) continue;
    best = q;
    hit = {std::max(q, 1e-9), face.first[k], face.second[k], t, true};
  }
  if (hit.found) return hit;
  core::Vec2 const middle = p + 0.5 * c;
  for (int s = range.first; s <= range.last; ++s) {
    auto const [t, far] = nearest(face, s, middle);
    if (far >= best) continue;
    best = far;
    auto const k = static_cast<std::size_t>(s);
    hit = {0.5, face.first[k], face.second[k], t, false};
  }
  return hit;
}

double distance(FaceLine const& face, FaceIndex const& index, core::Vec2 p)
{
  Range const range = rows_near(index, p[1]);
  double best = std::numeric_limits<double>::infinity();
  for (int s = range.first; s <= range.last; ++s) best = std::min(best, nearest(face, s, p).second);
  return best;
}

}  // namespace velum::ibm
