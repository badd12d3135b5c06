#pragma once
#include <string>
#include <vector>

#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"
#include "lbm/opening.hpp"
#include "lbm/walls.hpp"

namespace velum::cases {

/// One patch of a boundary on the lattice.
struct PatchOpening {
  std::string boundary;
  lbm::Opening opening;
  std::vector<lbm::Link> links;
};

/// Part of a side of the lattice box that slides along itself.
struct SlidingWall {
  std::string boundary;
  int along;  // axis of its motion
  lbm::LinkList links;
};

/// The fluid of a scene with its rigid surroundings, lattice units: lengths are metres / dx.
template <class Real, class L = lbm::D2Q9, class Stored = Real>
struct LatticeScene {
  Derived derived;
  lbm::Fluid<Real, L, Stored> fluid;
  lbm::Walls walls;
  std::vector<lbm::WallHit> wall_hits;  // those that no opening and no sliding wall took
  std::vector<PatchOpening> openings;
  std::vector<SlidingWall> sliding;
};

/// Builds fluid, walls, sliding walls and openings.
/// @param smagorinsky  constant, 0 for off
/// Throws core::InputError where a patch takes no link of the lattice.
template <class Real, class L = lbm::D2Q9, class Stored = Real>
LatticeScene<Real, L, Stored> make_lattice_scene(Scene const& scene, double smagorinsky);

/// What a boundary imposes at a time, in the units of lbm::apply: velocity, volume per step, or
/// pressure, lattice.
double lattice_target(Scene const& scene, Derived const& derived, Boundary const& boundary,
                      double time);

}  // namespace velum::cases
