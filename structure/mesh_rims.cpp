#include "structure/mesh_rims.hpp"

#include "structure/sheet_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace velum::structure {
namespace {

using Neighbours = std::vector<std::array<Neighbour, 3>>;

Neighbour const& beyond(Neighbours const& across, int triangle, int side)
{
  return across[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(side)];
}

/// A side and one of its two corners.
struct SideEnd {
  int triangle, side, corner;
};

/// The side that ends the fan of triangles around the corner which begins with a side of the rim.
SideEnd around(Neighbours const& across, SideEnd at)
{
  for (;;) {
    bool const leaves = at.side != at.corner;  // the fan's next side runs away from the corner
    at.side = leaves ? at.corner : (at.corner + 2) % 3;
    auto const& next = beyond(across, at.triangle, at.side);
    if (next.triangle < 0) return at;
    bool const leaves_there = leaves == next.same_way;
    at = {next.triangle, next.side, leaves_there ? next.side : (next.side + 1) % 3};
  }
}

}  // namespace

int rim_loops(Neighbours const& across)
{
  int loops = 0;
  std::set<std::pair<int, int>> seen;
  for (int t = 0; t < static_cast<int>(across.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      if (beyond(across, t, k).triangle != Neighbour::rim || seen.contains({t, k})) continue;
      ++loops;
      for (SideEnd at{t, k, (k + 1) % 3}; seen.insert({at.triangle, at.side}).second;) {
        at = around(across, at);
        at.corner = at.corner == at.side ? (at.side + 1) % 3 : at.side;
      }
    }
  return loops;
}

int slit_points(TriangleMesh const& mesh)
{
  auto const rim = rim_points(mesh);
  if (rim.empty()) return 0;
  auto const corners = mesh.points.reshaped(3, mesh.points.size() / 3);
  double const reach = 1e-9 * (corners.rowwise().maxCoeff() - corners.rowwise().minCoeff()).norm();
  // along a direction in which rows of a regular mesh do not fall together
  Eigen::Vector3d const direction(1, std::sqrt(2) / 2, std::sqrt(3) / 3);
  std::vector<std::pair<double, int>> sorted;
  for (int const p : rim) sorted.emplace_back(direction.dot(node3(mesh.points, p)), p);
  std::ranges::sort(sorted);
  std::set<int> slit;
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (auto j = i + 1; j < sorted.size(); ++j) {
      if (sorted[j].first - sorted[i].first > 2 * reach) break;
      int const a = sorted[i].second, b = sorted[j].second;
      if ((node3(mesh.points, a) - node3(mesh.points, b)).norm() <= reach) slit.insert({a, b});
    }
  return static_cast<int>(slit.size());
}

}  // namespace velum::structure
