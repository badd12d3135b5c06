#include "contact/surface_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "contact/surface_shape.hpp"
#include "core/check.hpp"

namespace velum::contact {
namespace {

/// Parts of a side from each of the three corners: a place on a triangle.
using Steps = std::array<int, 3>;

/// The corners of all small triangles, three by three.
std::vector<Steps> small_triangles(int n)
{
  std::vector<Steps> corners;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      int const k = n - i - j;
      corners.insert(corners.end(), {{i, j, k}, {i + 1, j, k - 1}, {i, j + 1, k - 1}});
      if (k >= 2)
        corners.insert(corners.end(),
                       {{i + 1, j, k - 1}, {i + 1, j + 1, k - 2}, {i, j + 1, k - 1}});
    }
  return corners;
}

/// What tells places apart, whichever triangle they are seen from: the nodes in ascending order
/// with their steps, those without steps left out.
std::vector<std::pair<int, int>> key(core::Triangle const& nodes, Steps const& steps)
{
  std::vector<std::pair<int, int>> k;
  for (std::size_t i = 0; i < 3; ++i)
    if (steps[i] > 0) k.emplace_back(nodes[i], steps[i]);
  std::ranges::sort(k);
  return k;
}

}  // namespace

std::vector<SurfacePoint> surface_points(SurfaceContact const& c, PointLayout const& layout)
{
  int const n = layout.per_side;
  core::require(n >= 1,
                fmt::format("The parts of a triangle's side in contact are {}; there must be "
                            "one at least.",
                            n));
  bool const both = layout.passes == Passes::both;
  core::require(both || std::ranges::any_of(c.body, [](int b) { return b > 0; }),
                "Only one body is there: the points of the first cannot touch a second; a body "
                "against itself needs both passes.");
  auto const corners = small_triangles(n);
  std::vector<SurfacePoint> points;
  std::map<std::vector<std::pair<int, int>>, std::size_t> known;
  for (int t = 0; t < static_cast<int>(c.triangles.size()); ++t) {
    auto const& nodes = c.triangles[static_cast<std::size_t>(t)];
    if (!both && c.body[static_cast<std::size_t>(nodes[0])] != 0) continue;
    double const area = core::norm(core::area_vector(corners_of(c.triangles, c.reference, t)));
    for (auto const& steps : corners) {
      auto const [it, is_new] = known.try_emplace(key(nodes, steps), points.size());
      if (is_new)
        points.push_back(
            {nodes, {double(steps[0]) / n, double(steps[1]) / n, double(steps[2]) / n}, 0, 0});
      auto& point = points[it->second];
      point.area += (both ? 0.5 : 1) * area / (3 * n * n);
      point.half = std::max(point.half, c.half[static_cast<std::size_t>(t)]);
    }
  }
  return points;
}

}  // namespace velum::contact
