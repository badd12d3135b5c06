#include "core/geometry/triangle.hpp"

namespace velum::core {

ClosestPoint closest_point(CornerAndEdges const& triangle, Vec3 const& p)
{
  auto const& [a, ab, ac] = triangle;
  Vec3 const ap = p - a;
  double const d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {a, Part::corner, 0};

  Vec3 const bp = ap - ab;
  double const d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {a + ab, Part::corner, 1};

  double const vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + (d1 / (d1 - d3)) * ab, Part::edge, 0};

  Vec3 const cp = ap - ac;
  double const d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {a + ac, Part::corner, 2};

  double const vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + (d2 / (d2 - d6)) * ac, Part::edge, 2};

  double const va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0)
    return {a + ab + (along / (along + back)) * (ac - ab), Part::edge, 1};

  double const whole = va + vb + vc;
  return {a + (vb / whole) * ab + (vc / whole) * ac, Part::face, 0};
}

std::optional<Crossing> crossing(CornerAndEdges const& triangle, Vec3 const& origin,
                                 Vec3 const& direction)
{
  auto const& [a, ab, ac] = triangle;
  Vec3 const h = cross(direction, ac);
  double const determinant = dot(ab, h);
  if (determinant == 0) return {};
  Vec3 const s = origin - a;
  double const u = dot(s, h) / determinant;
  if (u < 0 || u > 1) return {};
  Vec3 const q = cross(s, ab);
  double const v = dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return {};
  // The determinant is -direction . (ab x ac).
  return Crossing{dot(ac, q) / determinant, determinant < 0};
}

}  // namespace velum::core
