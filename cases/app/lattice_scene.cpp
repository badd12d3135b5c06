#include "cases/app/lattice_scene.hpp"

#include <fmt/format.h>

#include "cases/app/geometry.hpp"
#include "cases/app/velocity_profile.hpp"
#include "lbm/eddy_share.hpp"

namespace velum::cases {

namespace {

lbm::OpeningKind opening_kind(BoundaryKind kind)
{
  switch (kind) {
    case BoundaryKind::traction:
      return lbm::OpeningKind::traction;
    case BoundaryKind::pressure:
      return lbm::OpeningKind::pressure;
    case BoundaryKind::velocity:
      return lbm::OpeningKind::velocity;
    case BoundaryKind::flow_rate:
      return lbm::OpeningKind::flow_rate;
    case BoundaryKind::outflow:
    case BoundaryKind::moving_wall:  // makes no opening
      break;
  }
  return lbm::OpeningKind::outflow;
}

/// A patch as the lattice sees it: the side of the box or the solid it lies on, and its range.
struct PlacedPatch {
  std::optional<BoxSide> side;
  core::Obstacle solid;
  double from, to;  // lattice units
};

bool takes(PlacedPatch const& patch, lbm::WallHit const& hit, core::Vec2 upper_corner)
{
  double const along = hit.at[patch.side ? 1 - patch.side->axis : 1];
  if (along < patch.from || along > patch.to) return false;
  if (!patch.side)
    return !hit.box_side &&
           std::abs(core::distance(patch.solid, core::Vec2{hit.at[0], hit.at[1]})) < 1e-6;
  if (!hit.box_side) return false;
  int const axis = patch.side->axis,
            c = axis == 0 ? lbm::D2Q9::cx(hit.dir) : lbm::D2Q9::cy(hit.dir);
  int const cell = axis == 0 ? hit.i : hit.j;
  int const last = static_cast<int>(upper_corner[axis]) - 1;
  return patch.side->upper ? c == 1 && cell == last : c == -1 && cell == 0;
}

/// Into the fluid: off the side of the box, or the mean direction against the links.
core::Vec3 normal_of(PlacedPatch const& patch, std::vector<lbm::Link> const& links)
{
  core::Vec3 n;
  for (lbm::Link const& l : links)
    n -= lbm::D2Q9::w(l.dir) *
         core::Vec3{double(lbm::D2Q9::cx(l.dir)), double(lbm::D2Q9::cy(l.dir))};
  if (patch.side) {
    n = {};
    n[patch.side->axis] = patch.side->upper ? -1 : 1;
  }
  return (1 / norm(n)) * n;
}

lbm::Model model(Scene const& scene, Derived const& d, double smagorinsky)
{
  lbm::Model model;
  model.collision = scene.lattice.collision;
  model.viscosity = d.viscosity;
  model.magic = scene.lattice.magic;
  model.smagorinsky = smagorinsky;
  // The density of the rest state is 1, so that a force per volume is an acceleration.
  for (int axis = 0; axis < 2; ++axis)
    model.body_force[axis] = core::to_lattice_acceleration(d.units, scene.fluid.body_force[axis]);
  model.periodic_x = scene.lattice.periodic_x;
  model.periodic_y = scene.lattice.periodic_y;
  return model;
}

/// Turns the wall hits of a patch into an opening or a sliding wall; false where there are none.
template <class Real>
bool place(Scene const& scene, Boundary const& boundary, Patch const& patch,
           std::vector<char>& taken, LatticeScene<Real>& s)
{
  double const dx = s.derived.grid.dx;
  core::Vec2 const upper = {double(s.fluid.nx), double(s.fluid.ny)};
  PlacedPatch placed{box_side(patch.side), {}, patch.from / dx, patch.to / dx};
  if (!placed.side) placed.solid = core::transformed(solid(scene, patch.side), 1 / dx, {0, 0});

  std::vector<lbm::Link> links;
  std::vector<double> at;
  for (std::size_t k = 0; k < s.walls.hits.size(); ++k) {
    lbm::WallHit const& h = s.walls.hits[k];
    if (taken[k] || !takes(placed, h, upper)) continue;
    taken[k] = 1;
    links.push_back({h.i, h.j, std::int16_t(h.dir), 0, 1.0f, h.q});
    at.push_back(h.at[placed.side ? 1 - placed.side->axis : 1]);
  }
  if (links.empty()) return false;

  if (boundary.kind == BoundaryKind::moving_wall) {
    SlidingWall wall{boundary.name, 1 - placed.side->axis, {}};
    lbm::upload(wall.links, links);
    s.sliding.push_back(wall);
    return true;
  }
  PatchOpening opening{boundary.name, {}, {}};
  opening.opening.kind = opening_kind(boundary.kind);
  opening.opening.normal = normal_of(placed, links);
  shape_velocity(s.fluid, boundary.profile, at, placed.from, placed.to, opening.opening.normal,
                 links);
  opening.links = links;
  lbm::upload(opening.opening.links, opening.links);
  opening.opening.area = lbm::opening_area(s.fluid, opening.links, opening.opening.normal);
  s.openings.push_back(opening);
  return true;
}

}  // namespace

double lattice_target(Scene const& scene, Derived const& d, Boundary const& boundary, double time)
{
  double const value = value_at(boundary.value, time);
  switch (boundary.kind) {
    case BoundaryKind::velocity:
    case BoundaryKind::moving_wall:
      return core::to_lattice_velocity(d.units, value);
    case BoundaryKind::flow_rate:
      return core::to_lattice_flow_rate(d.units, symmetry(scene), value);
    default:
      return core::to_lattice_pressure(d.units, value);
  }
}

template <class Real>
LatticeScene<Real> make_lattice_scene(Scene const& scene, double smagorinsky)
{
  LatticeScene<Real> s;
  s.derived = derive(scene);
  core::Grid const& grid = s.derived.grid;
  s.fluid = lbm::make_fluid<Real>(grid.nx, grid.ny, (1 / grid.dx) * grid.origin, grid.symmetry,
                                  model(scene, s.derived, smagorinsky));
  s.solids = core::transformed(all_solids(scene), 1 / grid.dx, {0, 0});
  s.walls = lbm::find_walls(s.fluid, s.solids);
  lbm::deactivate_solids(s.fluid, s.walls);

  std::vector<char> taken(s.walls.hits.size(), 0);
  for (Boundary const& boundary : scene.boundaries)
    for (std::size_t p = 0; p < boundary.patches.size(); ++p)
      if (!place(scene, boundary, boundary.patches[p], taken, s))
        reject(scene, fmt::format("{}.patches", boundary.name),
               fmt::format("patch {} opens no cell of the lattice; a wider range or a smaller "
                           "lattice.dx would",
                           p));
  for (std::size_t k = 0; k < s.walls.hits.size(); ++k)
    if (!taken[k]) s.wall_hits.push_back(s.walls.hits[k]);
  if (smagorinsky > 0) lbm::spare_walls(s.fluid, s.wall_hits);
  return s;
}

template LatticeScene<float> make_lattice_scene(Scene const&, double);
template LatticeScene<double> make_lattice_scene(Scene const&, double);

}  // namespace velum::cases
