#include "cases/app/fluid_scene.hpp"

#include <cmath>

#include "cases/app/geometry.hpp"
#include "cases/app/initial_state.hpp"
#include "lbm/bounce_back.hpp"
#include "lbm/stream_and_collide.hpp"
#include "lbm/wall_force.hpp"

namespace velum::cases {
namespace {

/// Links of the resting walls that lie on a body, or all of them without one.
template <class Real>
lbm::LinkList links_on(LatticeScene<Real> const& lattice, core::Obstacle const* body)
{
  std::vector<lbm::Link> links;
  for (lbm::WallHit const& h : lattice.wall_hits)
    if (!body || (!h.box_side && std::abs(core::distance(*body, Vec2{h.at[0], h.at[1]})) < 1e-6))
      links.push_back(lbm::link_at(lattice.fluid, lattice.walls, h));
  lbm::LinkList list;
  lbm::upload(list, links);
  return list;
}

}  // namespace

template <class Real>
FluidScene<Real> make_fluid_scene(Scene const& scene, double smagorinsky)
{
  FluidScene<Real> s{&scene, make_lattice_scene<Real>(scene, smagorinsky), {}, {}};
  s.resting = links_on(s.lattice, nullptr);
  for (auto const& probe : scene.probes) {
    if (probe.kind != ProbeKind::force) continue;
    auto const body =
        core::transformed(solid(scene, probe.solid), 1 / s.lattice.derived.units.dx, {0, 0});
    s.bodies.push_back(links_on(s.lattice, &body));
  }
  set_initial_state(scene, s.lattice);
  return s;
}

template <class Real>
void step(FluidScene<Real>& s, double time)
{
  auto& fluid = s.lattice.fluid;
  auto const target = [&](std::string const& boundary) {
    return lattice_target(*s.scene, s.lattice.derived, *find_boundary(*s.scene, boundary), time);
  };
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

template <class Real>
Sampled sampled(FluidScene<Real> const& s)
{
  return {s.lattice.derived.grid, s.lattice.walls, lbm::cell_states(s.lattice.fluid),
          s.lattice.fluid.model.periodic_x, s.lattice.fluid.model.periodic_y};
}

template <class Real>
Vec2 body_force(FluidScene<Real>& s, std::size_t k)
{
  lbm::fill_ghosts(s.lattice.fluid);
  auto const f = lbm::wall_force(s.lattice.fluid, s.bodies[k]);
  auto const& units = s.lattice.derived.units;
  auto const symmetry = s.lattice.fluid.symmetry;
  return {core::to_si_force(units, symmetry, f[0]), core::to_si_force(units, symmetry, f[1])};
}

template FluidScene<float> make_fluid_scene(Scene const&, double);
template FluidScene<double> make_fluid_scene(Scene const&, double);
template void step(FluidScene<float>&, double);
template void step(FluidScene<double>&, double);
template Sampled sampled(FluidScene<float> const&);
template Sampled sampled(FluidScene<double> const&);
template Vec2 body_force(FluidScene<float>&, std::size_t);
template Vec2 body_force(FluidScene<double>&, std::size_t);

}  // namespace velum::cases
