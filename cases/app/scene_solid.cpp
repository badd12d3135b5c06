#include "cases/app/scene_sections.hpp"

#include "core/geometry/mesh_distance.hpp"
#include "core/geometry/stl.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace velum::cases {

using core::Dimension;

namespace {

bool is_of_space(SolidShape shape)
{
  return shape == SolidShape::sphere || shape == SolidShape::cylinder || shape == SolidShape::stl;
}

std::vector<std::string> keys_of(SolidShape shape, int dimensions)
{
  std::vector<std::string> keys{"shape", "shift", "operation"};
  switch (shape) {
    case SolidShape::box:
      keys.insert(keys.begin() + 1, {"from", "to"});
      if (dimensions == 2) keys.push_back("round");
      break;
    case SolidShape::disc:
      keys.insert(keys.begin() + 1, {"centre", "radius"});
      break;
    case SolidShape::profile:
      keys.insert(keys.begin() + 1, {"points", "round"});
      break;
    case SolidShape::sphere:
      keys.insert(keys.begin() + 1, {"centre", "radius"});
      break;
    case SolidShape::cylinder:
      keys.insert(keys.begin() + 1, {"from", "to", "radius"});
      break;
    case SolidShape::stl:
      keys.insert(keys.begin() + 1, {"file", "unit"});
      break;
  }
  return keys;
}

bool same(Vec2 const& a, Vec2 const& b) { return a[0] == b[0] && a[1] == b[1]; }

std::string show(Vec2 const& p) { return fmt::format("({:g}, {:g}) mm", 1e3 * p[0], 1e3 * p[1]); }

/// Twice the area of the triangle a, b, c: positive when it turns left.
double turn(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
  return core::dot(core::left_of(b - a), c - a);
}

/// True when c, on the line through a and b, lies between them.
bool between(Vec2 const& a, Vec2 const& b, Vec2 const& c) { return core::dot(a - c, b - c) <= 0; }

bool cross(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
  double const abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
         (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
}

/// A contour closes by itself; it may repeat its first point at the end, and must not cross itself.
std::vector<Vec2> read_contour(SceneTable& table)
{
  auto points = table.points("points");
  if (points.size() > 1 && same(points.front(), points.back())) points.pop_back();
  std::size_t const n = points.size();
  if (n < 3)
    table.fail("points",
               fmt::format("is an open contour: it has {} different point{}, and a closed "
                           "contour needs at least 3.",
                           n, n == 1 ? "" : "s"));
  for (std::size_t i = 0; i < n; ++i)
    if (same(points[i], points[(i + 1) % n]))
      table.fail("points",
                 fmt::format("has the point {} twice in a row; leave one out.", show(points[i])));
  for (std::size_t i = 0; i < n; ++i) {
    Vec2 const &a = points[i], &b = points[(i + 1) % n], &after = points[(i + 2) % n];
    if (turn(a, b, after) == 0 && core::dot(b - a, after - b) < 0)
      table.fail("points", fmt::format("turns back on itself at {}.", show(b)));
    for (std::size_t j = i + 2; j < n && (j + 1) % n != i; ++j) {
      Vec2 const &c = points[j], &d = points[(j + 1) % n];
      if (cross(a, b, c, d))
        table.fail("points", fmt::format("is a contour that crosses itself: the edge from {} to {} "
                                         "meets the edge from {} to {}.",
                                         show(a), show(b), show(c), show(d)));
    }
  }
  return points;
}

/// The solid in an STL file as a distance; what has no inside is refused.
core::SignedDistance<3> read_surface(SceneTable& table, std::string const& file)
{
  double const unit = table.quantity("unit", Dimension::length, Sign::positive);
  auto const mesh = core::read_stl(table.beside(file), unit);
  auto const topology = core::topology(mesh);
  if (!core::is_watertight(topology))
    table.fail("file", fmt::format("= \"{}\" is not the closed surface of a solid: it has {} open "
                                   "edges and {} of more than two triangles; `velum stl` reports "
                                   "what is wrong with it.",
                                   file, topology.open_edges, topology.non_manifold_edges));
  return core::mesh_distance(mesh);
}

}  // namespace

Solid read_solid(SceneTable table, std::string name)
{
  table.allow({"shape", "from", "to", "centre", "radius", "points", "round", "file", "unit",
               "shift", "operation"});
  Solid solid{.name = std::move(name), .shape = table.choice<SolidShape>("shape")};
  bool const space = table.dimensions() == 3;
  if (space ? solid.shape == SolidShape::disc : is_of_space(solid.shape))
    table.fail("shape", fmt::format("cannot be \"{}\" in {}.", word(solid.shape),
                                    space ? "space; \"sphere\" and \"cylinder\" can"
                                          : "a plane; \"disc\" and \"profile\" can"));
  table.allow(keys_of(solid.shape, table.dimensions()),
              fmt::format(" with shape = \"{}\"", word(solid.shape)));

  switch (solid.shape) {
    case SolidShape::box:
      solid.from = table.point("from");
      solid.to = table.point("to");
      for (int a = 0; a < table.dimensions(); ++a)
        if (solid.from[a] >= solid.to[a])
          table.fail("to", "must be larger than \"from\" in every coordinate.");
      break;
    case SolidShape::disc:
    case SolidShape::sphere:
      solid.centre = table.point("centre");
      solid.radius = table.quantity("radius", Dimension::length, Sign::positive);
      break;
    case SolidShape::cylinder:
      solid.from = table.point("from");
      solid.to = table.point("to");
      solid.radius = table.quantity("radius", Dimension::length, Sign::positive);
      break;
    case SolidShape::profile:
      solid.points = read_contour(table);
      break;
    case SolidShape::stl:
      solid.file = table.file_name("file");
      solid.surface = read_surface(table, solid.file);
      break;
  }
  solid.round = table.quantity("round", Dimension::length, Sign::not_negative, 0.0);
  solid.shift = table.point("shift", Vec3{});
  solid.operation = table.choice<Operation>("operation", Operation::add);
  return solid;
}

}  // namespace velum::cases
