#include "cases/app/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/revolved.hpp"

namespace velum::cases {
namespace {

core::Obstacle unshifted(Solid const& s)
{
  switch (s.shape) {
    case SolidShape::box:
      return core::box(core::in_plane(s.from), core::in_plane(s.to), s.round);
    case SolidShape::disc:
      return core::disc(core::in_plane(s.centre), s.radius);
    case SolidShape::profile:
      return core::polygon(s.points, s.round);
    case SolidShape::sphere:
    case SolidShape::cylinder:
    case SolidShape::stl:  // of space only
      break;
  }
  return {};
}

/// A solid of space.
core::SignedDistance<3> unshifted_in_space(Solid const& s)
{
  switch (s.shape) {
    case SolidShape::box:
      return core::box<3>(s.from, s.to);
    case SolidShape::sphere:
      return core::sphere(s.centre, s.radius);
    case SolidShape::cylinder:
      return core::cylinder(s.from, s.to, s.radius);
    case SolidShape::stl:
      return s.surface;
    case SolidShape::profile:
      return core::revolved(core::polygon(s.points, s.round));
    case SolidShape::disc:  // of a plane only
      break;
  }
  return {};
}

/// The union of the solids that add, without those that subtract, each put in its place.
template <class Geometry>
Geometry united(Scene const& scene, Geometry (*place)(Solid const&))
{
  std::vector<Geometry> added, removed;
  for (auto const& s : scene.solids)
    (s.operation == Operation::add ? added : removed).push_back(place(s));
  auto const all = core::unite(added);
  return removed.empty() ? all : core::subtract(all, core::unite(removed));
}

/// What is flat, as a distance that does not look at the third coordinate.
core::SignedDistance<3> extruded(core::Obstacle const& flat)
{
  return [flat](Vec3 const& p) { return core::distance(flat, core::in_plane(p)); };
}

/// Points along a range, half a spacing from its ends, at least two in a cell.
std::vector<double> samples(double from, double to, double dx)
{
  auto const n = static_cast<int>(std::ceil(2 * (to - from) / dx - 1e-9));
  std::vector<double> at;
  for (int k = 0; k < n; ++k) at.push_back(from + (k + 0.5) * (to - from) / n);
  return at;
}

/// Gap between the nearer face of the membrane and the seat at one place of the membrane.
double gap_at(MembraneSheet const& membrane, core::Obstacle const& seat, double y)
{
  double const half = 0.5 * value_at(membrane.thickness, y);
  return std::min(core::distance(seat, {membrane.position - half, y}),
                  core::distance(seat, {membrane.position + half, y}));
}

}  // namespace

core::Obstacle placed(Solid const& s)
{
  return core::transformed(unshifted(s), 1.0, core::in_plane(s.shift));
}

core::SignedDistance<3> placed_in_space(Solid const& s)
{
  return core::scaled(unshifted_in_space(s), 1.0, s.shift);
}

core::Obstacle solid(Scene const& scene, std::string const& name)
{
  return placed(*find_solid(scene, name));
}

core::Obstacle all_solids(Scene const& scene) { return united(scene, placed); }

core::SignedDistance<3> solid_distance(Scene const& scene, std::string const& name)
{
  return dimensions(scene) == 3 ? placed_in_space(*find_solid(scene, name))
                                : extruded(solid(scene, name));
}

core::SignedDistance<3> distance_to_solids(Scene const& scene)
{
  return dimensions(scene) == 3 ? united(scene, placed_in_space) : extruded(all_solids(scene));
}

std::optional<BoxSide> box_side(std::string const& side)
{
  if (side.size() != 2 || side[0] < 'x' || side[0] > 'z' || (side[1] != '-' && side[1] != '+'))
    return {};
  return BoxSide{side[0] - 'x', side[1] == '+'};
}

std::vector<std::string> side_names(int dimensions)
{
  std::vector<std::string> names = {"x-", "x+", "y-", "y+", "z-", "z+"};
  names.resize(static_cast<std::size_t>(2 * dimensions));
  return names;
}

bool is_mirror(Scene const& scene, BoxSide const& side)
{
  return (scene.lattice.mirrors & lbm::mirror(side.axis, side.upper)) != 0;
}

bool covers(Patch const& patch, Vec2 const& along, int dimensions)
{
  double squared = 0;
  for (int k = 0; k + 1 < dimensions; ++k) {
    if (along[k] < patch.from[k] || along[k] > patch.to[k]) return false;
    double const s = 2 * (along[k] - patch.from[k]) / (patch.to[k] - patch.from[k]) - 1;
    squared += s * s;
  }
  return !patch.disc || squared <= 1;
}

bool opens_to_fluid(Scene const& scene, Patch const& patch)
{
  auto const& lattice = scene.lattice;
  auto const walls = distance_to_solids(scene);
  auto const along = samples(patch.from[0], patch.to[0], lattice.dx);

  if (auto const side = box_side(patch.side)) {
    auto const second = dimensions(scene) == 3 ? samples(patch.from[1], patch.to[1], lattice.dx)
                                               : std::vector<double>{0};
    Vec3 p{};
    p[side->axis] = side->upper ? lattice.to[side->axis] - 0.5 * lattice.dx
                                : lattice.from[side->axis] + 0.5 * lattice.dx;
    for (double const s : along)
      for (double const t : second) {
        if (!covers(patch, {s, t}, dimensions(scene))) continue;
        p[axis_along(*side, 0)] = s;
        if (dimensions(scene) == 3) p[axis_along(*side, 1)] = t;
        if (walls(p) > 0) return true;
      }
    return false;
  }

  auto const body = solid_distance(scene, patch.side);
  auto const across = samples(lattice.from[0], lattice.to[0], lattice.dx);
  for (double const y : along)
    for (double const x : across) {
      double const d = body({x, y, 0});
      if (d > 0 && d <= lattice.dx && walls({x, y, 0}) > 0) return true;
    }
  return false;
}

double initial_gap(Scene const& scene)
{
  auto const& membrane = *scene.membrane;
  auto const seat = solid(scene, scene.contact->seat);
  double gap = std::numeric_limits<double>::infinity();
  for (double const y : samples(membrane.from, membrane.to, 0.25 * scene.lattice.dx))
    gap = std::min(gap, gap_at(membrane, seat, y));
  return gap;
}

double land_width(Scene const& scene)
{
  auto const& membrane = *scene.membrane;
  auto const seat = solid(scene, scene.contact->seat);
  double const limit = initial_gap(scene) + 0.1 * scene.lattice.dx;
  auto const along = samples(membrane.from, membrane.to, 0.25 * scene.lattice.dx);
  auto const inside = std::count_if(along.begin(), along.end(),
                                    [&](double y) { return gap_at(membrane, seat, y) <= limit; });
  return (membrane.to - membrane.from) * static_cast<double>(inside) /
         static_cast<double>(along.size());
}

}  // namespace velum::cases
