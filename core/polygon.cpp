#include "core/polygon.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace velum::core {
namespace {

double cross(Vec2 const& a, Vec2 const& b) { return a[0] * b[1] - a[1] * b[0]; }

Vec2 const& after(Outline const& outline, std::size_t k)
{
  return outline[k + 1 < outline.size() ? k + 1 : 0];
}

/// Unit normal on the right of the edge that starts at corner k: outward when counter-clockwise.
Vec2 outward(Outline const& outline, std::size_t k)
{
  Vec2 const edge = after(outline, k) - outline[k];
  return (-1 / norm(edge)) * left_of(edge);
}

Vec2 closest_on_edge(Vec2 const& a, Vec2 const& b, Vec2 const& p)
{
  Vec2 const edge = b - a;
  double const s = std::clamp(dot(p - a, edge) / dot(edge, edge), 0.0, 1.0);
  // Counted from the nearer end, so that a closest corner is that corner to the last bit.
  return s < 0.5 ? a + s * edge : b - (1 - s) * edge;
}

/// True when segments a b and c d have a point in common: each has its ends on both sides of the
/// line through the other, or on it.
bool segments_touch(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
  double const abc = cross(b - a, c - a), abd = cross(b - a, d - a);
  double const cda = cross(d - c, a - c), cdb = cross(d - c, b - c);
  if (abc == 0 && abd == 0) {  // on one line: do the intervals overlap?
    Vec2 const along = b - a;
    double const sc = dot(c - a, along), sd = dot(d - a, along), length2 = dot(along, along);
    return std::max(sc, sd) >= 0 && std::min(sc, sd) <= length2;
  }
  return abc * abd <= 0 && cda * cdb <= 0;
}

}  // namespace

double signed_area(Outline const& outline)
{
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k)
    twice += cross(outline[k] - outline[0], after(outline, k) - outline[0]);
  return twice / 2;
}

bool is_simple(Outline const& outline)
{
  std::size_t const n = outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    // Neighbours share a corner; they may only not fold back onto each other.
    Vec2 const &a = outline[k], &b = after(outline, k);
    Vec2 const edge = b - a, next = after(outline, (k + 1) % n) - b;
    if (cross(edge, next) == 0 && dot(edge, next) < 0) return false;
    for (std::size_t l = k + 2; l < n; ++l) {
      if (k == 0 && l == n - 1) continue;
      if (segments_touch(a, b, outline[l], after(outline, l))) return false;
    }
  }
  return true;
}

bool contains(Outline const& outline, Vec2 const& p)
{
  bool inside = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    Vec2 const& a = outline[k];
    Vec2 const& b = after(outline, k);
    if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
    double const side = cross(b - a, p - a);  // of one sign when the crossing lies ahead of p
    if ((b[1] > a[1]) == (side > 0)) inside = !inside;
  }
  return inside;
}

OutlinePoint nearest_point(Outline const& outline, Vec2 const& p)
{
  double best = std::numeric_limits<double>::infinity();
  std::size_t edge = 0;
  Vec2 point = p;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    Vec2 const candidate = closest_on_edge(outline[k], after(outline, k), p);
    double const distance2 = dot(p - candidate, p - candidate);
    if (distance2 < best) best = distance2, edge = k, point = candidate;
  }
  return {point, outward(outline, edge)};
}

Outline inset(Outline const& outline, double offset)
{
  std::size_t const n = outline.size();
  Outline moved(n);
  bool fits = true;
  for (std::size_t k = 0; k < n; ++k) {
    Vec2 const before = outward(outline, k > 0 ? k - 1 : n - 1), behind = outward(outline, k);
    moved[k] = outline[k] - (offset / (1 + dot(before, behind))) * (before + behind);
  }
  for (std::size_t k = 0; k < n && fits; ++k) {
    Vec2 const edge = after(outline, k) - outline[k], left = after(moved, k) - moved[k];
    double const depth = norm(nearest_point(outline, moved[k]).point - moved[k]);
    fits = dot(edge, left) > 0 && contains(outline, moved[k]) && depth >= offset * (1 - 1e-9);
  }
  require(fits && is_simple(moved), "The outline is too narrow for corners rounded with radius " +
                                        std::to_string(offset) + ": choose a smaller radius.");
  return moved;
}

}  // namespace velum::core
