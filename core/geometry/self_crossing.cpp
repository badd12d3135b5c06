#include "core/geometry/self_crossing.hpp"

#include "core/geometry/mesh_topology.hpp"

#include <algorithm>
#include <cstddef>

namespace velum::core {
namespace {

/// True when the edge from a to b goes through the inside of the facet: its ends are on different
/// sides of the plane, and it is within all three sides, by more than what may be round-off.
bool goes_through(Facet const& f, Vec3 const& a, Vec3 const& b, double roundoff)
{
  Vec3 const along = area_vector(f), n = (1 / norm(along)) * along;
  double const ha = dot(n, a - f[0]), hb = dot(n, b - f[0]);
  if (std::min(ha, hb) > -roundoff || std::max(ha, hb) < roundoff) return false;
  Vec3 const p = a + (ha / (ha - hb)) * (b - a);
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 const side = f[(k + 1) % 3] - f[k];
    if (dot(cross(n, side), p - f[k]) < roundoff * norm(side)) return false;
  }
  return true;
}

}  // namespace

int crossing_edges(TriangleMesh const& mesh, TriangleTree const& tree)
{
  double const roundoff = 1e-6 * diagonal(bounds(mesh));
  auto const at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  int count = 0;
  for (auto const& triangle : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      Edge const side = edge(triangle, k);
      if (!side.rising) continue;  // the neighbour looks at it
      auto const [low, high] = vertices_of(side);
      Vec3 const a = at(low), b = at(high);
      bool found = false;
      visit_crossings(tree, a, b - a, 1, [&](int other, Crossing const&) {
        auto const& corners = mesh.triangles[static_cast<std::size_t>(other)];
        bool const shares = std::any_of(corners.begin(), corners.end(),
                                        [&](int v) { return v == low || v == high; });
        found |= !shares && goes_through(facet(mesh, other), a, b, roundoff);
        return 1.0;
      });
      if (found) ++count;
    }
  return count;
}

}  // namespace velum::core
