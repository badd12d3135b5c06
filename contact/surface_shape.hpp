#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/triangle_foot.hpp"

namespace velum::contact {

/// Corners of a triangle of a surface as points, or what else there is of each point.
core::Facet corners_of(std::vector<core::Triangle> const& triangles,
                       std::vector<core::Vec3> const& of_points, int triangle);

/// Unit normals at the points of a surface: the mean of the triangles around by their areas.   [N]
std::vector<core::Vec3> point_normals(std::vector<core::Triangle> const& triangles,
                                      std::vector<core::Vec3> const& place);

/// Which points hang together: the number of each body's first point, for each point.   [N]
std::vector<int> bodies(std::vector<core::Triangle> const& triangles, std::size_t points);

/// Which sides and corners of each triangle are a rim: sides of one triangle only.
struct RimOf {
  std::array<bool, 3> side, corner;
};
std::vector<RimOf> rims(std::vector<core::Triangle> const& triangles, std::size_t points);

/// Nearest place of some triangles. On a rim it is clear only straight above: a point farther out
/// is beside the surface, on no side of it.
struct NearestFoot {
  int triangle;
  Foot foot;
};
/// @pre  `some` is not empty
NearestFoot nearest_foot(std::vector<core::Triangle> const& triangles,
                         std::vector<RimOf> const& rim, std::vector<core::Vec3> const& place,
                         std::vector<core::Vec3> const& normals, core::Vec3 const& x,
                         std::span<int const> some);

}  // namespace velum::contact
