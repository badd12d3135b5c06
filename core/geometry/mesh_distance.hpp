#pragma once
#include "core/geometry/orientation.hpp"
#include "core/signed_distance.hpp"

namespace velum::core {

/// How the side of the surface is found on which a point lies.
enum class SignRule {
  /// By the normal of what is nearest: of a face its own, of an edge the sum of both faces', of a
  /// vertex the sum of all its faces' weighted with their angles there. Exact (Baerentzen and
  /// Aanaes, IEEE Trans. Vis. Comput. Graph. 11, 2005, doi:10.1109/TVCG.2005.49) where the surface
  /// is closed, its normals point outward and no needle was taken out.
  pseudo_normals,
  /// By the majority of seven rays that count crossings; right too where normals are wrong, and a
  /// guess near holes.
  ray_votes,
};
SignRule sign_rule(TriangleMesh const& mesh, MeshTopology const& topology,
                   Orientation const& orientation);

/// Distance from a mesh, exact to round-off, in metres; its sign by sign_rule(). Shells that cross
/// each other are no solid with one inside: between them the sign may be wrong.
/// @pre the mesh has a triangle
SignedDistance<3> mesh_distance(TriangleMesh const& mesh);

}  // namespace velum::core
