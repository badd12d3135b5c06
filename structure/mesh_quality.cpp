#include "structure/mesh_quality.hpp"

#include "core/check.hpp"
#include "core/geometry/mesh_topology.hpp"
#include "structure/mesh_neighbours.hpp"
#include "structure/mesh_rims.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace velum::structure {
namespace {

constexpr double round_off = 1e-10;  // of a shape
constexpr double degree = std::numbers::pi / 180;

struct Measures {
  Eigen::Vector3d centroid;
  std::array<double, 3> edges;   // side k from corner k to the next
  std::array<double, 3> angles;  // degrees
  double area;

  double longest() const { return std::ranges::max(edges); }
  double squares() const { return edges[0] * edges[0] + edges[1] * edges[1] + edges[2] * edges[2]; }
  double height() const { return longest() > 0 ? 2 * area / longest() : 0; }
  double shape() const { return squares() > 0 ? 4 * std::numbers::sqrt3 * area / squares() : 0; }
  double size() const { return std::sqrt(squares() / 3); }
};

Measures measure(TriangleMesh const& mesh, std::size_t t)
{
  auto const& corners = mesh.triangles[t];
  std::array<Eigen::Vector3d, 3> x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = node3(mesh.points, corners[k]);
  Measures m;
  m.centroid = (x[0] + x[1] + x[2]) / 3;
  m.area = (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    Eigen::Vector3d const u = x[(k + 1) % 3] - x[k], v = x[(k + 2) % 3] - x[k];
    m.edges[k] = u.norm();
    m.angles[k] = std::atan2(2 * m.area, u.dot(v)) / degree;
  }
  return m;
}

/// Keeps the smaller, or the larger, of two.
void keep(TriangleExtreme& extreme, bool better, double value, std::size_t t, Measures const& m)
{
  if (better) extreme = {value, static_cast<int>(t), m.centroid};
}
void keep_smaller(TriangleExtreme& extreme, double value, std::size_t t, Measures const& m)
{
  keep(extreme, t == 0 || value < extreme.value, value, t, m);
}
void keep_larger(TriangleExtreme& extreme, double value, std::size_t t, Measures const& m)
{
  keep(extreme, t == 0 || value > extreme.value, value, t, m);
}

void add_sizes(TriangleMesh const& mesh, std::vector<std::array<Neighbour, 3>> const& across,
               MeshQuality& q)
{
  std::vector<double> sizes;
  q.shortest_edge = std::numeric_limits<double>::infinity();
  double edges = 0;  // each inner one by half from either side
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto const m = measure(mesh, t);
    q.shortest_edge = std::min(q.shortest_edge, std::ranges::min(m.edges));
    q.longest_edge = std::max(q.longest_edge, m.longest());
    for (std::size_t k = 0; k < 3; ++k) {
      double const share = across[t][k].triangle == Neighbour::rim ? 1 : 0.5;
      q.mean_edge += share * m.edges[k];
      edges += share;
    }
    keep_smaller(q.smallest_height, m.height(), t, m);
    keep_smaller(q.smallest_angle, std::ranges::min(m.angles), t, m);
    keep_larger(q.largest_angle, std::ranges::max(m.angles), t, m);
    keep_smaller(q.worst_shape, m.shape(), t, m);
    q.mean_shape += m.shape() / q.triangles;
    q.area += m.area;
    if (m.shape() < round_off) ++q.degenerate;
    sizes.push_back(m.size());
  }
  q.mean_edge /= edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double largest = 1;
    for (auto const& next : across[t])
      if (next.triangle >= 0)
        largest = std::max(largest, sizes[t] / sizes[static_cast<std::size_t>(next.triangle)]);
    keep_larger(q.size_jump, largest, t, measure(mesh, t));
  }
}

}  // namespace

MeshQuality mesh_quality(TriangleMesh const& mesh)
{
  core::require(!mesh.triangles.empty(), "A mesh without triangles has no quality.");
  auto const across = neighbours(mesh);
  MeshQuality q{};
  q.points = static_cast<int>(mesh.points.size()) / 3;
  q.triangles = static_cast<int>(mesh.triangles.size());
  auto const corners = mesh.points.reshaped(3, q.points);
  q.lo = corners.rowwise().minCoeff();
  q.hi = corners.rowwise().maxCoeff();
  auto const joined = core::topology({.vertices = {}, .triangles = mesh.triangles, .needles = {}});
  q.parts = joined.shells;
  q.closed = joined.open_edges == 0;
  q.crowded_edges = joined.non_manifold_edges;
  q.flipped_edges = joined.flipped_edges;
  q.rims = rim_loops(across);
  q.slit_points = slit_points(mesh);
  add_sizes(mesh, across, q);
  return q;
}

}  // namespace velum::structure
