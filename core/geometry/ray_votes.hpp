#pragma once
#include "core/geometry/triangle_tree.hpp"

namespace velum::core {

/// Directions without a common plane or axis, so that a ray which grazes an edge or leaves by a
/// hole is outvoted by the others.
inline constexpr int vote_count = 7;
inline Vec3 vote_direction(int k)
{
  static constexpr double table[vote_count][3] = {
      {0.8713, 0.3217, 0.3709},   {-0.4519, 0.7853, 0.4243}, {-0.3307, -0.6121, 0.7187},
      {0.5231, -0.7411, -0.4219}, {0.1913, 0.4937, -0.8483}, {-0.8117, -0.1301, -0.5693},
      {0.2877, -0.3173, 0.9041},
  };
  return {table[k][0], table[k][1], table[k][2]};
}

/// True when the ray crosses an odd number of those triangles for which counts(triangle) holds.
template <class Counts>
bool is_odd(TriangleTree const& tree, Vec3 const& origin, Vec3 const& direction,
            Counts const& counts)
{
  bool odd = false;
  visit_crossings(tree, origin, direction, Bounds::infinity, [&](int triangle, Crossing const&) {
    if (counts(triangle)) odd = !odd;
    return Bounds::infinity;
  });
  return odd;
}

/// True when most of the rays from p cross the surface an odd number of times: p is inside. Needs
/// no normals, and of a surface with holes that are small beside its distance from p no hole.
inline bool is_inside_by_votes(TriangleTree const& tree, Vec3 const& p)
{
  int inside = 0, outside = 0;
  for (int k = 0; inside <= vote_count / 2 && outside <= vote_count / 2; ++k)
    ++(is_odd(tree, p, vote_direction(k), [](int) { return true; }) ? inside : outside);
  return inside > outside;
}

}  // namespace velum::core
