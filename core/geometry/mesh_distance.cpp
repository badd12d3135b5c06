#include "core/geometry/mesh_distance.hpp"

#include "core/geometry/pseudo_normals.hpp"
#include "core/geometry/ray_votes.hpp"

#include <memory>

namespace velum::core {
namespace {

struct Surface {
  TriangleTree tree;
  SignRule rule;
  PseudoNormals normals;  // empty where rays vote
};

double signed_distance(Surface const& surface, Vec3 const& p)
{
  auto const [triangle, closest] = nearest(surface.tree, p);
  Vec3 const away = p - closest.point;
  double const length = norm(away);
  if (surface.rule == SignRule::pseudo_normals)
    return dot(away, surface.normals.of(triangle, closest)) < 0 ? -length : length;
  // Outside the box of the whole mesh no ray is needed.
  if (distance2(surface.tree.nodes.front().bounds, p) > 0) return length;
  return is_inside_by_votes(surface.tree, p) ? -length : length;
}

}  // namespace

SignRule sign_rule(TriangleMesh const& mesh, MeshTopology const& topology,
                   Orientation const& orientation)
{
  bool const clean = is_closed(topology) && orientation.normals == Normals::outward;
  return clean && mesh.needles.empty() ? SignRule::pseudo_normals : SignRule::ray_votes;
}

SignedDistance<3> mesh_distance(TriangleMesh const& mesh)
{
  auto const joined = topology(mesh);
  auto tree = make_tree(mesh);
  auto const rule = sign_rule(mesh, joined, orientation(mesh, joined, tree));
  auto normals = rule == SignRule::pseudo_normals ? pseudo_normals(mesh) : PseudoNormals{};
  auto const surface =
      std::make_shared<Surface const>(Surface{std::move(tree), rule, std::move(normals)});
  return [surface](Vec3 const& p) { return signed_distance(*surface, p); };
}

}  // namespace velum::core
