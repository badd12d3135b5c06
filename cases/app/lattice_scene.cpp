#include "cases/app/lattice_scene.hpp"

#include <fmt/format.h>

#include "cases/app/geometry.hpp"
#include "cases/app/open_area.hpp"
#include "cases/app/velocity_profile.hpp"
#include "lbm/eddy_share.hpp"
#include "lbm/formats.hpp"

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
    case BoundaryKind::port:
      return lbm::OpeningKind::flow_rate;
    case BoundaryKind::outflow:
    case BoundaryKind::moving_wall:  // makes no opening
      break;
  }
  return lbm::OpeningKind::outflow;
}

/// Memory of an outflow, in steps for a cell of the longest side: four times what sound takes. Much
/// shorter and it would hold its pressure against sound, longer and the start would be felt long.
constexpr double transits_remembered = 7;

/// Gain of a traction inlet's integral, of what a chamber as long as the box still damps. A smaller
/// one lets the pressure fall behind while a valve opens.
constexpr double gain_of_limit = 0.5;

/// So many cells before an opening a wall reflects half-way, wherever it lies. There the stream
/// turns into what the walls allow, within few cells; an interpolated wall takes or gives mass
/// where streams turn (of a uniform inflow into a slit 1 to 5 % over 8 and 4 cells), a half-way
/// wall none.
constexpr int half_way_before_openings = 3;

/// A patch as the lattice sees it: its range, and the side of the box or the solid it lies on.
/// Lattice units.
struct PlacedPatch {
  Patch range;
  std::optional<BoxSide> side;
  core::SignedDistance<3> solid;
};

PlacedPatch placed_patch(Scene const& scene, Patch const& patch)
{
  double const dx = scene.lattice.dx;
  PlacedPatch placed{patch, box_side(patch.side), {}};
  placed.range.from = (1 / dx) * patch.from;
  placed.range.to = (1 / dx) * patch.to;
  if (!placed.side) placed.solid = in_cells<3>(solid_distance(scene, patch.side), dx);
  return placed;
}

/// Where a wall is hit, along the patch.
Vec2 place_on(PlacedPatch const& patch, Vec3 const& at)
{
  if (!patch.side) return {at[1], 0};
  return {at[axis_along(*patch.side, 0)], at[axis_along(*patch.side, 1)]};
}

template <class Fluid, class L>
bool takes(PlacedPatch const& patch, lbm::WallHit const& hit, Fluid const& fluid)
{
  if (!covers(patch.range, place_on(patch, hit.at), L::D)) return false;
  if (!patch.side) return !hit.box_side && std::abs(patch.solid(hit.at)) < 1e-6;
  if (!hit.box_side) return false;
  int const axis = patch.side->axis, cell[] = {hit.i, hit.j, hit.k};
  int const last[] = {fluid.nx - 1, fluid.ny - 1, fluid.nz - 1};
  return patch.side->upper ? L::c(hit.dir, axis) == 1 && cell[axis] == last[axis]
                           : L::c(hit.dir, axis) == -1 && cell[axis] == 0;
}

/// Into the fluid: off the side of the box, or the mean direction against the links.
template <class L>
Vec3 normal_of(PlacedPatch const& patch, std::vector<lbm::Link> const& links)
{
  Vec3 n;
  if (patch.side) {
    n[patch.side->axis] = patch.side->upper ? -1 : 1;
    return n;
  }
  for (lbm::Link const& l : links)
    for (int a = 0; a < L::D; ++a) n[a] -= L::w(l.dir) * L::c(l.dir, a);
  return (1 / norm(n)) * n;
}

lbm::Model model(Scene const& scene, Derived const& d, double smagorinsky)
{
  lbm::Model model;
  model.collision = scene.lattice.collision;
  model.viscosity = d.viscosity;
  model.magic = scene.lattice.magic;
  model.wall_rule = scene.lattice.wall_rule;
  model.smagorinsky = smagorinsky;
  // The density of the rest state is 1, so that a force per volume is an acceleration.
  for (int axis = 0; axis < dimensions(scene); ++axis)
    model.body_force[axis] = core::to_lattice_acceleration(d.units, scene.fluid.body_force[axis]);
  model.periodic_x = scene.lattice.periodic[0];
  model.periodic_y = scene.lattice.periodic[1];
  model.periodic_z = scene.lattice.periodic[2];
  model.mirrors = scene.lattice.mirrors;
  // room for twice the velocity that the scene is made for; the guard tells where it is not enough
  model.storage_range =
      lbm::storage_range_for(2 * core::to_lattice_velocity(d.units, d.velocity), dimensions(scene));
  return model;
}

/// Turns the wall hits of a patch into an opening or a sliding wall; false where there are none.
template <class Real, class L, class Stored>
bool place(Scene const& scene, Boundary const& boundary, Patch const& patch,
           std::vector<char>& taken, LatticeScene<Real, L, Stored>& s)
{
  PlacedPatch const placed = placed_patch(scene, patch);
  std::vector<lbm::Link> links;
  std::vector<Vec2> at;
  for (std::size_t k = 0; k < s.walls.hits.size(); ++k) {
    lbm::WallHit const& h = s.walls.hits[k];
    if (taken[k] || !takes<lbm::Fluid<Real, L, Stored>, L>(placed, h, s.fluid)) continue;
    taken[k] = 1;
    links.push_back({h.i, h.j, std::int16_t(h.dir), lbm::Stencil::half_way, 1.0f, h.q, h.k});
    at.push_back(place_on(placed, h.at));
  }
  if (links.empty()) return false;

  if (boundary.kind == BoundaryKind::moving_wall) {
    int const axis = L::D == 3 ? static_cast<int>(boundary.along) : axis_along(*placed.side, 0);
    SlidingWall wall{boundary.name, axis, {}};
    lbm::upload(wall.links, links);
    s.sliding.push_back(wall);
    return true;
  }
  PatchOpening opening{boundary.name, {}, {}};
  opening.opening.kind = opening_kind(boundary.kind);
  opening.opening.normal = normal_of<L>(placed, links);
  shape_velocity(s.fluid, boundary.profile, placed.range, at, opening.opening.normal, links);
  if (boundary.kind == BoundaryKind::velocity && placed.side) {
    // the mean velocity times the true area: the links at a corner count half
    double const share = open_area(scene, s.derived, patch) /
                         lbm::opening_area(s.fluid, links, opening.opening.normal);
    for (lbm::Link& l : links) l.weight *= static_cast<float>(share);
  }
  opening.links = links;
  lbm::upload(opening.opening.links, opening.links);
  int const longest = std::max({s.fluid.nx, s.fluid.ny, s.fluid.nz});
  opening.opening.memory = transits_remembered * longest;
  opening.opening.gain = gain_of_limit * lbm::sound / (4 * longest);
  opening.opening.area = lbm::opening_area(s.fluid, opening.links, opening.opening.normal);
  s.openings.push_back(opening);
  return true;
}

/// Marks the cells about those of an opening.
template <class Real, class L, class Stored>
std::vector<char> cells_before_openings(LatticeScene<Real, L, Stored> const& s)
{
  std::vector<char> before(s.walls.solid.size(), 0);
  int const reach = half_way_before_openings - 1, size[] = {s.fluid.nx, s.fluid.ny, s.fluid.nz};
  for (PatchOpening const& opening : s.openings)
    for (lbm::Link const& l : opening.links) {
      int const at[] = {l.i, l.j, l.k};
      int from[3], to[3];
      for (int a = 0; a < 3; ++a) {
        from[a] = std::max(at[a] - reach, 0);
        to[a] = std::min(at[a] + reach, size[a] - 1);
      }
      for (int k = from[2]; k <= to[2]; ++k)
        for (int j = from[1]; j <= to[1]; ++j)
          for (int i = from[0]; i <= to[0]; ++i) before[s.walls.index(i, j, k)] = 1;
    }
  return before;
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

template <class Real, class L, class Stored>
LatticeScene<Real, L, Stored> make_lattice_scene(Scene const& scene, double smagorinsky)
{
  LatticeScene<Real, L, Stored> s;
  s.derived = derive(scene);
  core::Grid const& grid = s.derived.grid;
  core::Vec<double, L::D> origin;
  for (int a = 0; a < L::D; ++a) origin[a] = grid.origin[a] / grid.dx;
  s.fluid = lbm::make_fluid<Real, L, Stored>(grid.nx, grid.ny, origin, grid.symmetry,
                                             model(scene, s.derived, smagorinsky), grid.nz);
  s.walls = lbm::find_walls(s.fluid, in_cells<L::D>(distance_to_solids(scene), grid.dx));
  lbm::deactivate_solids(s.fluid, s.walls);

  std::vector<char> taken(s.walls.hits.size(), 0);
  for (Boundary const& boundary : scene.boundaries)
    for (std::size_t p = 0; p < boundary.patches.size(); ++p)
      if (!place(scene, boundary, boundary.patches[p], taken, s))
        reject(scene, fmt::format("{}.patches", boundary.name),
               fmt::format("patch {} opens no cell of the lattice; a wider range or a smaller "
                           "lattice.dx would",
                           p));
  std::vector<char> const before = cells_before_openings(s);
  for (std::size_t k = 0; k < s.walls.hits.size(); ++k) {
    if (taken[k]) continue;
    lbm::WallHit hit = s.walls.hits[k];
    if (before[s.walls.index(hit.i, hit.j, hit.k)]) hit.q = 0.5;
    s.wall_hits.push_back(hit);
  }
  if (smagorinsky > 0 && scene.les.model != LesModel::vreman)  // which sees walls by itself
    lbm::spare_walls(s.fluid, s.wall_hits);
  return s;
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                              \
  template LatticeScene<Real, lbm::L, Stored> make_lattice_scene<Real, lbm::L, Stored>( \
      Scene const&, double);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::cases
