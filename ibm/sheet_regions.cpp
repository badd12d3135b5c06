#include "ibm/sheet_regions.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace velum::ibm {
namespace {

/// Disjoint sets of nodes; each set is known by one of them.
struct Sets {
  std::vector<int> parent;

  explicit Sets(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), 0); }

  int of(int a)
  {
    while (parent[static_cast<std::size_t>(a)] != a) {
      int& up = parent[static_cast<std::size_t>(a)];
      up = parent[static_cast<std::size_t>(up)];
      a = up;
    }
    return a;
  }
  void join(int a, int b) { parent[static_cast<std::size_t>(of(a))] = of(b); }
};

}  // namespace

SheetRegions find_regions(std::span<structure::Triangle const> triangles,
                          std::vector<double> pressing, RegionSeeds const& seeds)
{
  SheetRegions r{{}, std::move(pressing), false, false};
  auto const free = [&](int a) { return r.pressing[static_cast<std::size_t>(a)] <= 0; };
  r.node.assign(r.pressing.size(), Below::land);
  r.touches = std::ranges::any_of(r.pressing, [](double p) { return p > 0; });

  Sets sets(r.pressing.size());
  for (auto const& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (free(t[i]) && free(t[(i + 1) % 3])) sets.join(t[i], t[(i + 1) % 3]);

  // The side of each set, told at the node that it is known by.
  auto side = r.node;
  for (int a : seeds.downstream)
    if (free(a)) side[static_cast<std::size_t>(sets.of(a))] = Below::downstream;
  bool joined = false;
  for (int a : seeds.upstream) {
    if (!free(a)) continue;
    auto& known = side[static_cast<std::size_t>(sets.of(a))];
    joined = joined || known == Below::downstream;
    known = Below::upstream;
  }
  r.sealed = r.touches && !joined;
  for (int a = 0; a < static_cast<int>(r.node.size()); ++a) {
    if (!free(a)) continue;
    auto const found = side[static_cast<std::size_t>(sets.of(a))];
    // an open valve leaves no fluid at rest; the land's lip law has no second side to go to
    r.node[static_cast<std::size_t>(a)] = joined ? Below::upstream : found;
  }
  return r;
}

}  // namespace velum::ibm
