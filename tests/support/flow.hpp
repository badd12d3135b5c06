#pragma once
#include <functional>
#include <type_traits>
#include <vector>

#include "core/obstacle.hpp"
#include "core/signed_distance.hpp"
#include "lbm/bounce_back.hpp"
#include "lbm/opening.hpp"
#include "lbm/stream_and_collide.hpp"
#include "lbm/walls.hpp"

namespace velum::tests {

/// A fluid between rigid walls, some of them moving, with openings: enough to march a test.
template <class Real, class L = lbm::D2Q9, class Stored = Real>
struct Flow {
  lbm::Fluid<Real, L, Stored> fluid;
  lbm::Walls walls;
  lbm::LinkList resting, moving;
  core::Vec3 wall_velocity = {};
  double wall_mass = 0;  // that has come in through walls off the half-way
  std::vector<lbm::Opening> openings;
  std::vector<double> targets;
};

/// Which part of the boundary a hit belongs to: -1 rest, -2 moving wall, k >= 0 opening k.
using Assign = std::function<int(lbm::WallHit const&)>;
using Profile = std::function<double(core::Vec3)>;

struct OpeningSpec {
  lbm::OpeningKind kind;
  core::Vec3 normal;
  double target;
  Profile profile = [](core::Vec3) { return 1.0; };
};

template <class Real, class L, class Stored>
Flow<Real, L, Stored> make_flow(lbm::Fluid<Real, L, Stored> fluid,
                                std::type_identity_t<core::SignedDistance<L::D>> const& solids,
                                Assign const& assign, std::vector<OpeningSpec> const& specs = {})
{
  Flow<Real, L, Stored> flow;
  flow.fluid = fluid;
  flow.walls = lbm::find_walls(fluid, solids);
  lbm::deactivate_solids(flow.fluid, flow.walls);
  std::vector<lbm::Link> resting, moving;
  std::vector<std::vector<lbm::Link>> open(specs.size());
  for (lbm::WallHit const& h : flow.walls.hits) {
    int const part = assign(h);
    double const weight = part >= 0 ? specs[static_cast<std::size_t>(part)].profile(h.at) : 1.0;
    lbm::Link const link = lbm::link_at(fluid, flow.walls, h, weight);
    (part == -1   ? resting
     : part == -2 ? moving
                  : open[static_cast<std::size_t>(part)])
        .push_back(link);
  }
  lbm::upload(flow.resting, resting);
  lbm::upload(flow.moving, moving);
  for (std::size_t k = 0; k < specs.size(); ++k) {
    lbm::Opening opening;
    opening.kind = specs[k].kind;
    opening.normal = specs[k].normal;
    lbm::upload(opening.links, open[k]);
    opening.area = lbm::opening_area(fluid, open[k], specs[k].normal);
    flow.openings.push_back(opening);
    flow.targets.push_back(specs[k].target);
  }
  return flow;
}

template <class Real, class Stored>
Flow<Real, lbm::D2Q9, Stored> make_flow(lbm::Fluid<Real, lbm::D2Q9, Stored> fluid,
                                        core::Obstacle const& solids, Assign const& assign,
                                        std::vector<OpeningSpec> const& specs = {})
{
  return make_flow(
      fluid, [&](core::Vec2 const& p) { return core::distance(solids, p); }, assign, specs);
}

template <class Real, class L, class Stored>
void step(Flow<Real, L, Stored>& flow)
{
  lbm::fill_ghosts(flow.fluid);
  flow.wall_mass += lbm::bounce_back(flow.fluid, flow.resting, {});
  flow.wall_mass += lbm::bounce_back(flow.fluid, flow.moving, flow.wall_velocity);
  for (std::size_t k = 0; k < flow.openings.size(); ++k)
    lbm::apply(flow.fluid, flow.openings[k], flow.targets[k]);
  lbm::stream_and_collide(flow.fluid);
}

/// Opening 0 is the left side of the box and opening 1 the right side, all else walls.
template <class L = lbm::D2Q9>
Assign open_ends(int nx)
{
  return [nx](lbm::WallHit const& h) {
    int const cx = L::c(h.dir, 0);
    return h.i == 0 && cx < 0 ? 0 : h.i == nx - 1 && cx > 0 ? 1 : -1;
  };
}

inline core::Obstacle no_solids() { return core::box({-1e9, -1e9}, {-1e8, -1e8}); }

}  // namespace velum::tests
