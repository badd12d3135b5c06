#include "contact/surface_shape.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace velum::contact {

core::Facet corners_of(std::vector<core::Triangle> const& triangles,
                       std::vector<core::Vec3> const& of_points, int triangle)
{
  auto const& t = triangles[static_cast<std::size_t>(triangle)];
  auto const at = [&](int i) { return of_points[static_cast<std::size_t>(i)]; };
  return {at(t[0]), at(t[1]), at(t[2])};
}

std::vector<core::Vec3> point_normals(std::vector<core::Triangle> const& triangles,
                                      std::vector<core::Vec3> const& place)
{
  std::vector<core::Vec3> normals(place.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    auto const along = core::area_vector(corners_of(triangles, place, t));
    for (int i : triangles[static_cast<std::size_t>(t)])
      normals[static_cast<std::size_t>(i)] += along;
  }
  for (auto& n : normals)
    if (double const length = norm(n); length > 0) n *= 1 / length;
  return normals;
}

std::vector<int> bodies(std::vector<core::Triangle> const& triangles, std::size_t points)
{
  std::vector<int> body(points);
  std::iota(body.begin(), body.end(), 0);
  auto const root = [&](int i) {
    auto const at = [&](int k) -> int& { return body[static_cast<std::size_t>(k)]; };
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  };
  for (auto const& t : triangles)
    for (int i : {t[1], t[2]}) {
      int const a = root(t[0]), b = root(i);
      body[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  for (std::size_t i = 0; i < points; ++i) body[i] = root(static_cast<int>(i));
  return body;
}

std::vector<RimOf> rims(std::vector<core::Triangle> const& triangles, std::size_t points)
{
  std::map<std::pair<int, int>, int> uses;
  auto const side = [](core::Triangle const& t, std::size_t k) {
    return std::pair<int, int>(std::minmax(t[k], t[(k + 1) % 3]));
  };
  for (auto const& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[side(t, k)];
  std::vector<char> at_rim(points, 0);
  for (auto const& [ends, count] : uses)
    if (count == 1)
      at_rim[static_cast<std::size_t>(ends.first)] = at_rim[static_cast<std::size_t>(ends.second)] =
          1;
  std::vector<RimOf> rim;
  for (auto const& t : triangles)
    for (auto& r = rim.emplace_back(); std::size_t k : {0, 1, 2}) {
      r.side[k] = uses[side(t, k)] == 1;
      r.corner[k] = at_rim[static_cast<std::size_t>(t[k])];
    }
  return rim;
}

NearestFoot nearest_foot(std::vector<core::Triangle> const& triangles,
                         std::vector<RimOf> const& rim, std::vector<core::Vec3> const& place,
                         std::vector<core::Vec3> const& normals, core::Vec3 const& x,
                         std::span<int const> some)
{
  constexpr double straight = 0.999;
  int nearest = some[0];
  double least = std::numeric_limits<double>::infinity();
  for (int const t : some) {
    auto const c = corners_of(triangles, place, t);
    auto const arm = x - core::closest_point({c[0], c[1] - c[0], c[2] - c[0]}, x).point;
    if (double const square = dot(arm, arm); square < least) least = square, nearest = t;
  }
  NearestFoot n{nearest, foot(corners_of(triangles, place, nearest), x,
                              corners_of(triangles, normals, nearest))};
  auto const& of = rim[static_cast<std::size_t>(nearest)];
  auto const k = static_cast<std::size_t>(n.foot.k);
  if ((n.foot.part == core::Part::edge && of.side[k]) ||
      (n.foot.part == core::Part::corner && of.corner[k]))
    n.foot.clear = n.foot.cosine >= straight;
  return n;
}

}  // namespace velum::contact
