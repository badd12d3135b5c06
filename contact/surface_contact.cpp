#include "contact/surface_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/penalty.hpp"
#include "contact/surface_points.hpp"
#include "contact/surface_shape.hpp"
#include "core/check.hpp"

namespace velum::contact {
namespace {

using Places = std::vector<core::Vec3>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

SurfaceTouch touch(SurfaceContact const& c, Places const& place, Places const& normals, int near)
{
  auto const& n = c.list.near[at(near)];
  auto const x = place_of(c.points[at(n.point)], place);
  std::span const triangles(c.list.triangles);
  auto const [triangle, foot] =
      n.held >= 0 ? NearestFoot{n.held, foot_on_plane(corners_of(c.triangles, place, n.held), x)}
                  : nearest_foot(c.triangles, c.rim, place, normals, x,
                                 triangles.subspan(at(n.first), at(n.last - n.first)));
  auto const height = signed_height(foot, n.side);
  double const gap = height.distance - c.points[at(n.point)].half - c.half[at(triangle)];
  return {near, triangle, foot, height, gap, traction(c.stiffness, gap, n.multiplier)};
}

}  // namespace

SurfaceContact make_surface_contact(std::vector<core::Triangle> triangles, Places reference,
                                    Places const& place, std::vector<double> half, double stiffness,
                                    PointLayout const& layout)
{
  core::require(stiffness > 0,
                fmt::format("The stiffness of a contact is {}; it must be above 0.", stiffness));
  for (double const h : half)
    core::require(h > 0, fmt::format("Half of a thickness in contact is {}; it must be above 0: "
                                     "without it a surface has no sides to tell apart.",
                                     h));
  SurfaceContact c{.triangles = std::move(triangles),
                   .reference = std::move(reference),
                   .body = {},
                   .rim = {},
                   .half = std::move(half),
                   .points = {},
                   .stiffness = stiffness,
                   .hold = false,
                   .skin = 0,
                   .place = {},
                   .covered = {},
                   .margin = 0,
                   .list = {}};
  c.body = bodies(c.triangles, c.reference.size());
  c.rim = rims(c.triangles, c.reference.size());
  c.points = surface_points(c, layout);
  c.skin = c.half.empty() ? 0 : std::ranges::min(c.half);
  follow(c, place);
  return c;
}

Places point_places(SurfaceContact const& c, Places const& place)
{
  Places places;
  for (auto const& p : c.points) places.push_back(place_of(p, place));
  return places;
}

std::vector<SurfaceTouch> touches(SurfaceContact const& c, Places const& place)
{
  std::vector<SurfaceTouch> found;
  auto const normals = point_normals(c.triangles, place);
  for (int n = 0; n < static_cast<int>(c.list.near.size()); ++n)
    if (auto const t = touch(c, place, normals, n); t.traction > 0) found.push_back(t);
  return found;
}

TouchForce force(SurfaceContact const& c, SurfaceTouch const& t)
{
  auto const& point = c.points[at(c.list.near[at(t.near)].point)];
  auto const& corners = c.triangles[at(t.triangle)];
  core::Vec3 const f = point.area * t.traction * t.height.normal;
  TouchForce touch;
  for (std::size_t i = 0; i < 3; ++i) {
    touch.node[i] = point.nodes[i], touch.node[i + 3] = corners[i];
    touch.share[i] = point.share[i], touch.share[i + 3] = 1;
    touch.force[i] = point.share[i] * f, touch.force[i + 3] = -t.foot.weight[i] * f;
  }
  return touch;
}

Matrix12 tangent(SurfaceContact const& c, SurfaceTouch const& t, Places const& place)
{
  double const area = c.points[at(c.list.near[at(t.near)].point)].area;
  Matrix12 K = second_derivative(corners_of(c.triangles, place, t.triangle), t.foot, t.height);
  std::array<double, 4> const w{1, -t.foot.weight[0], -t.foot.weight[1], -t.foot.weight[2]};
  auto const slope = [&](std::size_t i) { return w[i / 3] * t.height.normal[int(i % 3)]; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j < 12; ++j)
      K[i][j] = area * (t.traction * K[i][j] - c.stiffness * slope(i) * slope(j));
  return K;
}

double update_multipliers(SurfaceContact& c, Places const& place)
{
  cover(c, place);
  double change = 0;
  auto const normals = point_normals(c.triangles, place);
  for (int n = 0; n < static_cast<int>(c.list.near.size()); ++n) {
    double& lambda = c.list.near[at(n)].multiplier;
    double const updated = touch(c, place, normals, n).traction;
    change = std::max(change, std::abs(updated - lambda));
    lambda = updated;
  }
  return change;
}

SurfaceSum sum_up(SurfaceContact const& c, Places const& place)
{
  SurfaceSum sum;
  auto const normals = point_normals(c.triangles, place);
  for (int n = 0; n < static_cast<int>(c.list.near.size()); ++n) {
    auto const& near = c.list.near[at(n)];
    auto const t = touch(c, place, normals, n);
    double const area = c.points[at(near.point)].area;
    sum.energy +=
        area / (2 * c.stiffness) * (t.traction * t.traction - near.multiplier * near.multiplier);
    sum.penetration = std::max(sum.penetration, -t.gap);
    if (t.traction <= 0) continue;
    sum.area += area;
    sum.largest = std::max(sum.largest, t.traction);
    sum.complementarity = std::max(sum.complementarity, std::abs(t.traction * t.gap));
    auto const f = force(c, t);
    for (std::size_t i = 0; i < 6; ++i)
      if (c.body[at(f.node[i])] == 0) sum.force += f.force[i];
  }
  return sum;
}

}  // namespace velum::contact
