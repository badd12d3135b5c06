#include "cases/app/fluid_scene.hpp"

#include <algorithm>
#include <cmath>

#include "cases/app/geometry.hpp"
#include "cases/app/initial_state.hpp"
#include "lbm/bounce_back.hpp"
#include "lbm/formats.hpp"
#include "lbm/stream_and_collide.hpp"
#include "lbm/wall_force.hpp"

namespace velum::cases {
namespace {

/// Wall hits on a body.
std::vector<lbm::WallHit> hits_on(std::vector<lbm::WallHit> const& all,
                                  core::SignedDistance<3> const& body)
{
  std::vector<lbm::WallHit> hits;
  for (lbm::WallHit const& h : all)
    if (!h.box_side && std::abs(body(h.at)) < 1e-6) hits.push_back(h);
  return hits;
}

template <class Real, class L, class Stored>
lbm::LinkList links_of(LatticeScene<Real, L, Stored> const& lattice,
                       std::vector<lbm::WallHit> const& hits)
{
  std::vector<lbm::Link> links;
  for (lbm::WallHit const& h : hits) links.push_back(lbm::link_at(lattice.fluid, lattice.walls, h));
  lbm::LinkList list;
  lbm::upload(list, links);
  return list;
}

/// A plane of symmetry beside which the body has links cuts it: the image doubles what is along the
/// plane and takes away what is across.
template <class Fluid>
Vec3 whole_body(Fluid const& fluid, std::vector<lbm::WallHit> const& hits)
{
  Vec3 whole{1, 1, 1};
  int const last[] = {fluid.nx - 1, fluid.ny - 1, fluid.nz - 1};
  for (int axis = 0; axis < 3; ++axis)
    for (bool const upper : {false, true}) {
      if ((fluid.model.mirrors & lbm::mirror(axis, upper)) == 0) continue;
      if (std::none_of(hits.begin(), hits.end(), [&](lbm::WallHit const& h) {
            int const cell[] = {h.i, h.j, h.k};
            return cell[axis] == (upper ? last[axis] : 0);
          }))
        continue;
      for (int a = 0; a < 3; ++a) whole[a] *= a == axis ? 0 : 2;
    }
  return whole;
}

/// A stream that is there from the beginning is no wave for the openings to damp.
template <class Real, class L, class Stored>
void open_to_stream(FluidScene<Real, L, Stored>& s)
{
  double const speed =
      core::to_lattice_velocity(s.lattice.derived.units, s.scene->initial.velocity);
  for (auto& [boundary, opening, links] : s.lattice.openings)
    opening.velocity = opening.slow_velocity = opening.integral = speed * opening.normal[0];
}

}  // namespace

template <class Real, class L, class Stored>
FluidScene<Real, L, Stored> make_fluid_scene(Scene const& scene, double smagorinsky)
{
  FluidScene<Real, L, Stored> s{
      &scene, make_lattice_scene<Real, L, Stored>(scene, smagorinsky), {}, {}};
  s.resting = links_of(s.lattice, s.lattice.wall_hits);
  for (auto const& probe : scene.probes) {
    if (probe.kind != ProbeKind::force) continue;
    auto const hits = hits_on(s.lattice.wall_hits, in_cells<3>(solid_distance(scene, probe.solid),
                                                               s.lattice.derived.units.dx));
    s.bodies.push_back({links_of(s.lattice, hits), whole_body(s.lattice.fluid, hits)});
  }
  set_initial_state(scene, s.lattice);
  if (scene.initial.kind == InitialKind::uniform) open_to_stream(s);
  if (scene.les.model == LesModel::vreman)
    s.vreman = lbm::make_vreman(s.lattice.fluid, scene.les.constant);
  return s;
}

template <class Real, class L, class Stored>
void step(FluidScene<Real, L, Stored>& s, double time)
{
  auto& fluid = s.lattice.fluid;
  auto const target = [&](std::string const& boundary) {
    return lattice_target(*s.scene, s.lattice.derived, *find_boundary(*s.scene, boundary), time);
  };
  if (s.vreman && s.steps % vreman_every == 0) lbm::set_vreman_share(fluid, *s.vreman);
  ++s.steps;
  lbm::fill_ghosts(fluid);
  lbm::bounce_back(fluid, s.resting, {});
  for (auto const& wall : s.lattice.sliding) {
    core::Vec3 velocity;
    velocity[wall.along] = target(wall.boundary);
    lbm::bounce_back(fluid, wall.links, velocity);
  }
  for (auto& o : s.lattice.openings) lbm::apply(fluid, o.opening, target(o.boundary));
  lbm::stream_and_collide(fluid);
}

template <class Real, class L, class Stored>
Sampled sampled(FluidScene<Real, L, Stored> const& s)
{
  return {s.lattice.derived.grid, s.lattice.walls, lbm::cell_states(s.lattice.fluid),
          s.scene->lattice.periodic};
}

template <class Real, class L, class Stored>
Vec3 body_force(FluidScene<Real, L, Stored>& s, std::size_t k)
{
  lbm::fill_ghosts(s.lattice.fluid);
  auto const f = lbm::wall_force(s.lattice.fluid, s.bodies[k].links);
  auto const& units = s.lattice.derived.units;
  Vec3 force;
  for (int a = 0; a < L::D; ++a)
    force[a] = s.bodies[k].whole[a] * core::to_si_force(units, s.lattice.fluid.symmetry, f[a]);
  return force;
}

#define VELUM_INSTANTIATE(Real, L, Stored)                                                       \
  template FluidScene<Real, lbm::L, Stored> make_fluid_scene<Real, lbm::L, Stored>(Scene const&, \
                                                                                   double);      \
  template void step(FluidScene<Real, lbm::L, Stored>&, double);                                 \
  template Sampled sampled(FluidScene<Real, lbm::L, Stored> const&);                             \
  template Vec3 body_force(FluidScene<Real, lbm::L, Stored>&, std::size_t);
VELUM_EACH_FLUID(VELUM_INSTANTIATE)
#undef VELUM_INSTANTIATE

}  // namespace velum::cases
