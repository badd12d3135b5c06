#include "core/obstacle.hpp"

#include "core/check.hpp"
#include "core/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

namespace velum::core {
namespace {

struct Box {
  Vec2 centre, half;  // half sides of the rectangle that is grown by round
  double round;
};

struct Disc {
  Vec2 centre;
  double radius;
};

struct Polygon {
  Outline outline;  // counter-clockwise; grown by round
  double round;
};

struct Union {
  std::vector<Obstacle> parts;
};

struct Difference {
  Obstacle a, b;
};

struct Transformed {
  Obstacle obstacle;
  double scale;
  Vec2 shift;
};

NearestSurface surface(Box const& box, Vec2 const& p)
{
  Vec2 const r = p - box.centre;
  Vec2 const side{r[0] < 0 ? -1.0 : 1.0, r[1] < 0 ? -1.0 : 1.0};
  Vec2 const q{std::abs(r[0]) - box.half[0], std::abs(r[1]) - box.half[1]};
  if (q[0] > 0 && q[1] > 0) {
    double const corner = norm(q);
    return {corner - box.round, {side[0] * q[0] / corner, side[1] * q[1] / corner}};
  }
  if (q[0] > q[1]) return {q[0] - box.round, {side[0], 0}};
  return {q[1] - box.round, {0, side[1]}};
}

NearestSurface surface(Disc const& disc, Vec2 const& p)
{
  Vec2 const r = p - disc.centre;
  double const length = norm(r);
  return {length - disc.radius, length > 0 ? (1 / length) * r : Vec2{1, 0}};
}

NearestSurface surface(Polygon const& polygon, Vec2 const& p)
{
  auto const [point, edge_normal] = nearest_point(polygon.outline, p);
  Vec2 const away = p - point;
  double const length = norm(away);
  double const sign = contains(polygon.outline, p) ? -1 : 1;
  // On the outline the direction to it is lost in round-off; the edge still knows its normal.
  bool const on_outline = length <= 1e-12 * (norm(point) + length);
  return {sign * length - polygon.round, on_outline ? edge_normal : (sign / length) * away};
}

NearestSurface surface(Union const& all, Vec2 const& p)
{
  NearestSurface best = nearest_surface({}, p);
  for (auto const& part : all.parts) {
    NearestSurface const candidate = nearest_surface(part, p);
    if (candidate.distance < best.distance) best = candidate;
  }
  return best;
}

NearestSurface surface(Difference const& difference, Vec2 const& p)
{
  NearestSurface const a = nearest_surface(difference.a, p), b = nearest_surface(difference.b, p);
  return a.distance >= -b.distance ? a : NearestSurface{-b.distance, -1.0 * b.normal};
}

NearestSurface surface(Transformed const& moved, Vec2 const& p)
{
  auto const [distance, normal] =
      nearest_surface(moved.obstacle, (1 / moved.scale) * (p - moved.shift));
  return {moved.scale * distance, normal};
}

}  // namespace

struct Shape {
  std::variant<Box, Disc, Polygon, Union, Difference, Transformed> kind;
};

namespace {

template <class Kind>
Obstacle obstacle(Kind kind)
{
  return {std::make_shared<Shape const>(Shape{std::move(kind)})};
}

bool is_finite(Vec2 const& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }

}  // namespace

NearestSurface nearest_surface(Obstacle const& obstacle, Vec2 const& p)
{
  if (!obstacle.shape) return {std::numeric_limits<double>::infinity(), {0, 0}};
  return std::visit([&](auto const& kind) { return surface(kind, p); }, obstacle.shape->kind);
}

double distance(Obstacle const& obstacle, Vec2 const& p)
{
  return nearest_surface(obstacle, p).distance;
}

Vec2 gradient(Obstacle const& obstacle, Vec2 const& p)
{
  return nearest_surface(obstacle, p).normal;
}

Obstacle box(Vec2 const& lo, Vec2 const& hi, double round)
{
  Vec2 const half = 0.5 * (hi - lo);
  require(is_finite(lo) && is_finite(hi) && half[0] > 0 && half[1] > 0,
          "A box needs its first corner below its second in both directions.");
  require(round >= 0 && round <= std::min(half[0], half[1]),
          "The corner radius of a box must lie between zero and half its shorter side.");
  return obstacle(Box{0.5 * (lo + hi), half - Vec2{round, round}, round});
}

Obstacle disc(Vec2 const& centre, double radius)
{
  require(is_finite(centre) && std::isfinite(radius) && radius > 0,
          "A disc needs a positive radius.");
  return obstacle(Disc{centre, radius});
}

Obstacle polygon(std::vector<Vec2> const& corners, double round)
{
  require(std::all_of(corners.begin(), corners.end(), is_finite),
          "The corners of a polygon must be finite numbers.");
  require(corners.size() >= 3, "A polygon needs at least three corners.");
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Vec2 const edge = corners[(k + 1) % corners.size()] - corners[k];
    require(norm(edge) > 0,
            "Two neighbouring corners of a polygon are the same point; the outline closes by "
            "itself, so its first corner is not repeated at the end.");
  }
  require(is_simple(corners), "The outline of a polygon must not cross or touch itself.");
  require(round >= 0, "The corner radius of a polygon must not be negative.");

  Outline outline = corners;
  if (signed_area(outline) < 0) std::reverse(outline.begin(), outline.end());
  if (round > 0) outline = inset(outline, round);
  return obstacle(Polygon{std::move(outline), round});
}

Obstacle unite(std::vector<Obstacle> parts) { return obstacle(Union{std::move(parts)}); }

Obstacle subtract(Obstacle a, Obstacle b)
{
  return obstacle(Difference{std::move(a), std::move(b)});
}

Obstacle transformed(Obstacle moved, double scale, Vec2 const& shift)
{
  require(std::isfinite(scale) && scale > 0 && is_finite(shift),
          "An obstacle can only be scaled by a positive number.");
  return obstacle(Transformed{std::move(moved), scale, shift});
}

}  // namespace velum::core
