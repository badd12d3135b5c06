#include "core/geometry/orientation.hpp"

#include "core/geometry/ray_votes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace velum::core {
namespace {

/// Volume that each shell encloses, positive where its normals point out of it: sum of the
/// tetrahedra a . (b x c) / 6 over its triangles, from the first vertex of the mesh.
std::vector<double> shell_volumes(TriangleMesh const& mesh, MeshTopology const& topology)
{
  std::vector<double> volume(static_cast<std::size_t>(topology.shells), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto const [a, b, c] = facet(mesh, static_cast<int>(t));
    Vec3 const& o = mesh.vertices.front();
    volume[static_cast<std::size_t>(topology.shell[t])] += dot(a - o, cross(b - o, c - o)) / 6;
  }
  return volume;
}

/// True when the shell lies inside an odd number of others, by a vote of rays from its triangles.
bool is_cavity(TriangleMesh const& mesh, MeshTopology const& topology, TriangleTree const& tree,
               int shell)
{
  std::vector<int> own;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (topology.shell[t] == shell) own.push_back(static_cast<int>(t));
  auto const is_other = [&](int t) { return topology.shell[static_cast<std::size_t>(t)] != shell; };
  int inside = 0;
  for (int k = 0; k < vote_count; ++k) {
    auto const place = static_cast<std::size_t>(k) * own.size() / vote_count;
    Facet const f = facet(mesh, own[place]);
    Vec3 const centroid = (1.0 / 3) * (f[0] + f[1] + f[2]);
    if (is_odd(tree, centroid, vote_direction(k), is_other)) ++inside;
  }
  return inside > vote_count / 2;
}

}  // namespace

Orientation orientation(TriangleMesh const& mesh, MeshTopology const& topology,
                        TriangleTree const& tree)
{
  Orientation result{
      Normals::unknown, std::vector<bool>(static_cast<std::size_t>(topology.shells), false), {}};
  if (!is_watertight(topology)) return result;
  result.normals = Normals::mixed;
  if (topology.flipped_edges > 0) return result;

  auto const volumes = shell_volumes(mesh, topology);
  double solid = 0;
  for (int s = 0; s < topology.shells; ++s) {
    auto const k = static_cast<std::size_t>(s);
    bool const cavity = topology.shells > 1 && is_cavity(mesh, topology, tree, s);
    result.inverted[k] = (volumes[k] < 0) != cavity;
    solid += (cavity ? -1 : 1) * std::abs(volumes[k]);
  }
  result.volume = solid;
  auto const wrong = std::count(result.inverted.begin(), result.inverted.end(), true);
  if (wrong == 0) result.normals = Normals::outward;
  if (wrong == topology.shells) result.normals = Normals::inward;
  return result;
}

}  // namespace velum::core
