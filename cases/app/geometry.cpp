#include "cases/app/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace velum::cases {
namespace {

core::Obstacle unshifted(Solid const& s)
{
  switch (s.shape) {
    case SolidShape::box:
      return core::box(s.from, s.to, s.round);
    case SolidShape::disc:
      return core::disc(s.centre, s.radius);
    case SolidShape::profile:
      return core::polygon(s.points, s.round);
  }
  return {};
}

core::Obstacle placed(Solid const& s) { return core::transformed(unshifted(s), 1.0, s.shift); }

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

core::Obstacle solid(Scene const& scene, std::string const& name)
{
  return placed(*find_solid(scene, name));
}

core::Obstacle all_solids(Scene const& scene)
{
  std::vector<core::Obstacle> added, removed;
  for (auto const& s : scene.solids)
    (s.operation == Operation::add ? added : removed).push_back(placed(s));
  auto const all = core::unite(added);
  return removed.empty() ? all : core::subtract(all, core::unite(removed));
}

std::optional<BoxSide> box_side(std::string const& side)
{
  if (side == "x-") return BoxSide{0, false};
  if (side == "x+") return BoxSide{0, true};
  if (side == "y-") return BoxSide{1, false};
  if (side == "y+") return BoxSide{1, true};
  return {};
}

bool opens_to_fluid(Scene const& scene, Patch const& patch)
{
  auto const& lattice = scene.lattice;
  auto const walls = all_solids(scene);
  auto const along = samples(patch.from, patch.to, lattice.dx);

  if (auto const side = box_side(patch.side)) {
    Vec2 p{};
    p[side->axis] = side->upper ? lattice.to[side->axis] - 0.5 * lattice.dx
                                : lattice.from[side->axis] + 0.5 * lattice.dx;
    return std::any_of(along.begin(), along.end(), [&](double s) {
      p[1 - side->axis] = s;
      return core::distance(walls, p) > 0;
    });
  }

  auto const body = solid(scene, patch.side);
  auto const across = samples(lattice.from[0], lattice.to[0], lattice.dx);
  for (double const y : along)
    for (double const x : across) {
      double const d = core::distance(body, {x, y});
      if (d > 0 && d <= lattice.dx && core::distance(walls, {x, y}) > 0) return true;
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
