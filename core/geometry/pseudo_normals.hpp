#pragma once
#include "core/geometry/triangle.hpp"
#include "core/geometry/triangle_mesh.hpp"

#include <array>
#include <vector>

namespace velum::core {

/// Normals, of no particular length, of the faces, edges and corners of a mesh: on the side of the
/// surface to which the normal of the nearest of them points lies the fluid.
/// Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005), doi:10.1109/TVCG.2005.49
struct PseudoNormals {
  std::vector<Vec3> face;                   // unit normal n                    [triangles]
  std::vector<std::array<Vec3, 3>> edge;    // n of this and of the next face   [triangles][edges]
  std::vector<std::array<Vec3, 3>> corner;  // sum of angle times n         [triangles][corners]

  Vec3 const& of(int triangle, ClosestPoint const& closest) const
  {
    auto const t = static_cast<std::size_t>(triangle), k = static_cast<std::size_t>(closest.k);
    return closest.part == Part::face   ? face[t]
           : closest.part == Part::edge ? edge[t][k]
                                        : corner[t][k];
  }
};

PseudoNormals pseudo_normals(TriangleMesh const& mesh);

}  // namespace velum::core
