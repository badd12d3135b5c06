#pragma once
#include "cases/app/lattice_scene.hpp"
#include "cases/app/sample.hpp"

namespace velum::cases {

/// A scene without a membrane, ready to march: the fluid, its walls, its openings and the links of
/// the bodies on which forces are measured.
template <class Real>
struct FluidScene {
  Scene const* scene;
  LatticeScene<Real> lattice;
  lbm::LinkList resting;
  std::vector<lbm::LinkList> bodies;  // of the force probes, in the order of the scene's probes
};

/// Builds the scene in its initial state.
/// @param scene  must outlive the result
template <class Real>
FluidScene<Real> make_fluid_scene(Scene const& scene, double smagorinsky);

/// One step: ghosts, walls, sliding walls, openings, then streaming and collision.
/// @param time  at the beginning of the step, s
template <class Real>
void step(FluidScene<Real>& s, double time);

/// The flow on the host, to be read between its cells.
template <class Real>
Sampled sampled(FluidScene<Real> const& s);

/// Force on the body of the k-th force probe in the step that comes next, SI (planar: per depth).
template <class Real>
Vec2 body_force(FluidScene<Real>& s, std::size_t k);

}  // namespace velum::cases
