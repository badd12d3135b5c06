#include "ibm/swept_volume.hpp"

#include <algorithm>
#include <vector>

namespace velum::ibm {

namespace {

using Polygon = std::vector<core::Vec2>;

/// The part of a polygon on one side of the line y = bound. Where it crosses itself the parts keep
/// their signs. Sutherland & Hodgman, Commun. ACM 17 (1974) 32.
Polygon clipped(Polygon const& polygon, double bound, bool above)
{
  auto const kept = [&](core::Vec2 p) { return above ? p[1] >= bound : p[1] <= bound; };
  Polygon part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    core::Vec2 const p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    if (kept(p)) part.push_back(p);
    if (kept(p) != kept(q))
      part.push_back({p[0] + (q[0] - p[0]) * (bound - p[1]) / (q[1] - p[1]), bound});
  }
  return part;
}

}  // namespace

double swept_volume(FaceLine const& before, FaceLine const& after, std::size_t s, Rows rows,
                    core::Symmetry symmetry)
{
  Polygon swept = {before.points[s], before.points[s + 1], after.points[s + 1], after.points[s]};
  auto const [low, high] = std::minmax({swept[0][1], swept[1][1], swept[2][1], swept[3][1]});
  if (low < rows.lowest) swept = clipped(swept, rows.lowest, true);
  if (high > rows.highest) swept = clipped(swept, rows.highest, false);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < swept.size(); ++k) {
    core::Vec2 const origin = swept[0];  // near, so that little is lost to round-off
    core::Vec2 const u = swept[k] - origin, v = swept[k + 1] - origin;
    double const y = origin[1] + (u[1] + v[1]) / 3;  // of the triangle's centre
    sum += (u[1] * v[0] - u[0] * v[1]) / 2 * core::ring(symmetry, y);
  }
  return sum;
}

}  // namespace velum::ibm
