#include "core/geometry/mesh_topology.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace velum::core {
namespace {

struct EdgeUse {
  Edge edge;
  int triangle;  // needles are counted on after the triangles
};

/// All edges of all triangles and needles, those in the same place next to each other.
std::vector<EdgeUse> sorted_edges(TriangleMesh const& mesh)
{
  std::vector<EdgeUse> uses;
  int number = 0;
  for (auto const* part : {&mesh.triangles, &mesh.needles})
    for (auto const& triangle : *part) {
      for (int k = 0; k < 3; ++k) uses.push_back({edge(triangle, k), number});
      ++number;
    }
  std::sort(uses.begin(), uses.end(), [](EdgeUse const& a, EdgeUse const& b) {
    return std::tie(a.edge.place, a.triangle) < std::tie(b.edge.place, b.triangle);
  });
  return uses;
}

/// Sets that are joined pair by pair (union-find with halved paths).
struct Sets {
  std::vector<int> parent;

  explicit Sets(std::size_t count) : parent(count) { std::iota(parent.begin(), parent.end(), 0); }
  int& up(int k) { return parent[static_cast<std::size_t>(k)]; }
  int root(int k)
  {
    while (up(k) != k) k = up(k) = up(up(k));
    return k;
  }
  void join(int a, int b) { up(root(a)) = root(b); }
};

}  // namespace

Edge edge(Triangle const& triangle, int k)
{
  auto const a = static_cast<std::uint64_t>(triangle[static_cast<std::size_t>(k)]);
  auto const b = static_cast<std::uint64_t>(triangle[static_cast<std::size_t>((k + 1) % 3)]);
  return {std::min(a, b) << 32 | std::max(a, b), a < b};
}

MeshTopology topology(TriangleMesh const& mesh)
{
  MeshTopology result;
  auto const uses = sorted_edges(mesh);
  Sets sets(mesh.triangles.size() + mesh.needles.size());
  for (std::size_t from = 0, to = 0; from < uses.size(); from = to) {
    while (to < uses.size() && uses[to].edge.place == uses[from].edge.place) {
      sets.join(uses[from].triangle, uses[to].triangle);
      ++to;
    }
    if (to - from == 1) ++result.open_edges;
    if (to - from > 2) ++result.non_manifold_edges;
    if (to - from == 2 && uses[from].edge.rising == uses[from + 1].edge.rising)
      ++result.flipped_edges;
  }

  std::vector<int> number(sets.parent.size(), -1);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    int& shell = number[static_cast<std::size_t>(sets.root(t))];
    if (shell < 0) shell = result.shells++;
    result.shell.push_back(shell);
  }
  return result;
}

}  // namespace velum::core
