#include "core/geometry/pseudo_normals.hpp"

#include "core/geometry/mesh_topology.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace velum::core {
namespace {

/// Angle of a facet at its corner k.
double angle(Facet const& f, std::size_t k)
{
  Vec3 const a = f[(k + 1) % 3] - f[k], b = f[(k + 2) % 3] - f[k];
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

}  // namespace

PseudoNormals pseudo_normals(TriangleMesh const& mesh)
{
  PseudoNormals normals;
  std::unordered_map<std::uint64_t, Vec3> at_edge;
  std::vector<Vec3> at_vertex(mesh.vertices.size());
  auto const count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    Facet const f = facet(mesh, static_cast<int>(t));
    Vec3 const along = area_vector(f), n = (1 / norm(along)) * along;
    normals.face.push_back(n);
    for (std::size_t k = 0; k < 3; ++k) {
      at_edge[edge(mesh.triangles[t], static_cast<int>(k)).place] += n;
      at_vertex[static_cast<std::size_t>(mesh.triangles[t][k])] += angle(f, k) * n;
    }
  }
  normals.edge.resize(count);
  normals.corner.resize(count);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      normals.edge[t][k] = at_edge[edge(mesh.triangles[t], static_cast<int>(k)).place];
      normals.corner[t][k] = at_vertex[static_cast<std::size_t>(mesh.triangles[t][k])];
    }
  return normals;
}

}  // namespace velum::core
