#include "core/geometry/triangle_tree.hpp"

#include <cstddef>
#include <limits>
#include <numeric>

namespace velum::core {
namespace {

constexpr int leaf_size = 4;

/// Builds the nodes over a range of the order, which is sorted on the way. Halving leaves the tree
/// at most 30 levels deep.
struct Builder {
  std::vector<Bounds> bounds;
  std::vector<Vec3> centre;
  std::vector<int> order;
  double padding;  // so that round-off puts no crossing outside its box
  std::vector<TriangleTree::Node> nodes = {};

  static std::size_t at(int k) { return static_cast<std::size_t>(k); }

  void build(int first, int count)
  {
    Bounds all, centres;
    for (int k = first; k < first + count; ++k) {
      extend(all, bounds[at(order[at(k)])]);
      extend(centres, centre[at(order[at(k)])]);
    }
    Vec3 const pad{padding, padding, padding};
    int const node = static_cast<int>(nodes.size());
    nodes.push_back({{all.lo - pad, all.hi + pad}, first, count});
    if (count <= leaf_size) return;

    Vec3 const size = centres.hi - centres.lo;
    int const axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    int const half = count / 2;
    auto const begin = order.begin() + first;
    std::nth_element(begin, begin + half, begin + count,
                     [&](int a, int b) { return centre[at(a)][axis] < centre[at(b)][axis]; });
    build(first, half);
    nodes[at(node)].first = static_cast<int>(nodes.size());
    nodes[at(node)].count = 0;
    build(first + half, count - half);
  }
};

}  // namespace

TriangleTree make_tree(TriangleMesh const& mesh)
{
  auto const count = static_cast<int>(mesh.triangles.size());
  Builder builder{{}, {}, std::vector<int>(mesh.triangles.size()), 1e-12 * diagonal(bounds(mesh))};
  std::iota(builder.order.begin(), builder.order.end(), 0);
  for (int t = 0; t < count; ++t) {
    Facet const f = facet(mesh, t);
    Bounds box;
    for (auto const& corner : f) extend(box, corner);
    builder.bounds.push_back(box);
    builder.centre.push_back((1.0 / 3) * (f[0] + f[1] + f[2]));
  }
  builder.build(0, count);

  TriangleTree tree{std::move(builder.nodes), {}, std::move(builder.order)};
  for (int const t : tree.number) {
    Facet const f = facet(mesh, t);
    tree.triangles.push_back({f[0], f[1] - f[0], f[2] - f[0]});
  }
  return tree;
}

NearestTriangle nearest(TriangleTree const& tree, Vec3 const& p)
{
  struct Waiting {
    int node;
    double distance2;
  };
  std::array<Waiting, 64> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, 0};
  double best = std::numeric_limits<double>::infinity();
  NearestTriangle result{};
  while (waiting > 0) {
    auto const [number, least] = stack[--waiting];
    if (least >= best) continue;
    auto const& node = tree.nodes[static_cast<std::size_t>(number)];
    if (node.count == 0) {  // the nearer child on top, so that it is looked at first
      Waiting near{number + 1, 0}, far{node.first, 0};
      for (auto* child : {&near, &far})
        child->distance2 = distance2(tree.nodes[static_cast<std::size_t>(child->node)].bounds, p);
      if (far.distance2 < near.distance2) std::swap(near, far);
      stack[waiting++] = far;
      stack[waiting++] = near;
      continue;
    }
    for (auto k = static_cast<std::size_t>(node.first),
              end = k + static_cast<std::size_t>(node.count);
         k < end; ++k) {
      auto const closest = closest_point(tree.triangles[k], p);
      Vec3 const away = p - closest.point;
      double const d2 = dot(away, away);
      if (d2 < best) best = d2, result = {tree.number[k], closest};
    }
  }
  return result;
}

}  // namespace velum::core
