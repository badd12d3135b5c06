#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/near_pairs.hpp"
#include "contact/surface_points.hpp"
#include "contact/surface_shape.hpp"

namespace velum::contact {
namespace {

using core::Vec3;
using Places = std::vector<Vec3>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

core::Bounds grown(core::Bounds box, double by)
{
  Vec3 const all{by, by, by};
  return {box.lo - all, box.hi + all};
}

double largest_move(Places const& from, Places const& to)
{
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) largest = std::max(largest, norm(to[i] - from[i]));
  return largest;
}

/// Places of nodes and of the points that touch, before and after a motion.
struct Way {
  Places const& from;
  Places const& to;
  Places points_from, points_to;
};

/// Pairs of points and triangles whose boxes on the way come nearer than touching and a margin.
std::vector<Pair> pairs_on_the_way(SurfaceContact const& c, Way const& way, double margin)
{
  std::vector<core::Bounds> points(c.points.size()), triangles;
  double thickest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    thickest = std::max(thickest, c.points[i].half);
    extend(points[i], way.points_from[i]);
    extend(points[i], way.points_to[i]);
  }
  for (std::size_t t = 0; t < c.triangles.size(); ++t) {
    core::Bounds box;
    for (int corner : c.triangles[t]) {
      extend(box, way.from[at(corner)]);
      extend(box, way.to[at(corner)]);
    }
    triangles.push_back(grown(box, margin + thickest + c.half[t]));
  }
  return near_pairs(points, triangles);
}

double distance(SurfaceContact const& c, Places const& place, Vec3 const& x, int triangle)
{
  auto const f = corners_of(c.triangles, place, triangle);
  return norm(x - core::closest_point({f[0], f[1] - f[0], f[2] - f[0]}, x).point);
}

/// True where a point may touch a triangle on the way: no neighbour, and near enough.
bool may_touch(SurfaceContact const& c, Way const& way, double margin, Pair const& pair)
{
  auto const& point = c.points[at(pair.first)];
  auto const& corners = c.triangles[at(pair.second)];
  double const touching = point.half + c.half[at(pair.second)];
  if (c.body[at(point.nodes[0])] == c.body[at(corners[0])] &&
      distance(c, c.reference, place_of(point, c.reference), pair.second) < 2 * touching)
    return false;
  auto const& x = way.points_from[at(pair.first)];
  double moved = 0;
  for (int i : corners) moved = std::max(moved, norm(way.to[at(i)] - way.from[at(i)]));
  moved += norm(way.points_to[at(pair.first)] - x);
  return distance(c, way.from, x, pair.second) <= touching + margin + moved;
}

/// Joins what shares a point, in a list of triangles.
struct Parts {
  std::vector<int> stamp, seen, parent;
  int round = 0;

  explicit Parts(std::size_t points) : stamp(points, 0), seen(points, 0) {}

  int root(int k)
  {
    while (parent[at(k)] != k) k = parent[at(k)] = parent[at(parent[at(k)])];
    return k;
  }

  /// Number of the part of each triangle: that of its first one.
  void join(SurfaceContact const& c, std::vector<int> const& triangles)
  {
    ++round;
    parent.resize(triangles.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (int k = 0; k < static_cast<int>(triangles.size()); ++k)
      for (int corner : c.triangles[at(triangles[at(k)])]) {
        if (stamp[at(corner)] == round)
          parent[at(root(k))] = root(seen[at(corner)]);
        else
          stamp[at(corner)] = round, seen[at(corner)] = k;
      }
  }
};

NearestFoot nearest(SurfaceContact const& c, Places const& place, Places const& normals,
                    Near const& n, std::vector<int> const& triangles)
{
  return nearest_foot(c.triangles, c.rim, place, normals, place_of(c.points[at(n.point)], place),
                      {triangles.begin() + n.first, triangles.begin() + n.last});
}

/// Which side of a part a point is on; 0 where it is seen from beside.
int side_of(Foot const& f) { return !f.clear ? 0 : f.height < 0 ? -1 : 1; }

bool share_a_triangle(NearList const& a, Near const& i, NearList const& b, Near const& j)
{
  auto p = a.triangles.begin() + i.first, q = b.triangles.begin() + j.first;
  auto const p_end = a.triangles.begin() + i.last, q_end = b.triangles.begin() + j.last;
  while (p != p_end && q != q_end && *p != *q) (*p < *q ? ++p : ++q);
  return p != p_end && q != q_end;
}

/// Gives each part the side and multiplier of the one before that it shares a triangle with. A side
/// that is known stays, but for a point that has come beside the part. Parts that a point went
/// through, and is far beyond now, stay too.
void remember(SurfaceContact const& c, Places const& place, Places const& normals, NearList& now)
{
  auto const& old = c.list;
  std::vector<Near> lost;
  auto begin = now.near.begin();
  for (auto const& o : old.near) {
    while (begin != now.near.end() && begin->point < o.point) ++begin;
    bool found = false;
    for (auto n = begin; n != now.near.end() && n->point == o.point; ++n) {
      if (!share_a_triangle(old, o, now, *n)) continue;
      if (n->side != 0 && o.side != 0) n->side = o.side;
      n->multiplier = std::max(n->multiplier, o.multiplier);
      found = true;
    }
    if (found || o.side == 0) continue;
    auto const f = nearest(c, place, normals, o, old.triangles).foot;
    if (f.clear && signed_height(f, o.side).distance < 0) lost.push_back(o);
  }
  for (auto n : lost) {
    int const first = static_cast<int>(now.triangles.size());
    for (int k = n.first; k < n.last; ++k) now.triangles.push_back(old.triangles[at(k)]);
    n.last += first - n.first;
    n.first = first;
    now.near.push_back(n);
  }
  std::ranges::stable_sort(now.near, {}, &Near::point);
}

NearList search(SurfaceContact const& c, Places const& from, Places const& to, double margin)
{
  NearList list;
  Places const normals = point_normals(c.triangles, from);
  Parts parts(from.size());
  Way const way{from, to, point_places(c, from), point_places(c, to)};
  auto const pairs = pairs_on_the_way(c, way, margin);
  std::vector<int> around;
  for (std::size_t p = 0; p < pairs.size();) {
    int const point = pairs[p].first;
    around.clear();
    for (; p < pairs.size() && pairs[p].first == point; ++p)
      if (may_touch(c, way, margin, pairs[p])) around.push_back(pairs[p].second);
    parts.join(c, around);
    for (int k = 0; k < static_cast<int>(around.size()); ++k) {
      if (parts.root(k) != k) continue;
      Near n{point, static_cast<int>(list.triangles.size()), 0, 0, 0, -1};
      for (int m = 0; m < static_cast<int>(around.size()); ++m)
        if (parts.root(m) == k) list.triangles.push_back(around[at(m)]);
      n.last = static_cast<int>(list.triangles.size());
      n.side = side_of(nearest(c, from, normals, n, list.triangles).foot);
      list.near.push_back(n);
    }
  }
  remember(c, from, normals, list);
  return list;
}

/// Chooses the triangle that stands for each part; none for a part that is seen from beside.
void hold(SurfaceContact& c)
{
  if (!c.hold) {
    for (auto& n : c.list.near) n.held = -1;
    return;
  }
  auto const normals = point_normals(c.triangles, c.place);
  for (auto& n : c.list.near) {
    auto const at_place = nearest(c, c.place, normals, n, c.list.triangles);
    n.held = at_place.foot.clear ? at_place.triangle : -1;
  }
}

}  // namespace

void follow(SurfaceContact& c, Places const& place)
{
  c.place = place;
  bool const covers =
      !c.covered.empty() && c.margin == c.skin && largest_move(c.covered, place) <= c.margin / 2;
  if (!covers) {
    c.list = search(c, place, place, c.skin);
    c.covered = place;
    c.margin = c.skin;
  }
  hold(c);
}

void cover(SurfaceContact& c, Places const& place)
{
  double const off = largest_move(c.covered, place);
  if (!(off > c.margin / 2)) return;
  double const margin = std::max(c.skin, off / 2);
  c.list = search(c, c.place, place, margin);
  c.covered = place;
  c.margin = margin;
  hold(c);
}

}  // namespace velum::contact
