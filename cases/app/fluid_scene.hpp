#pragma once
#include "cases/app/lattice_scene.hpp"
#include "cases/app/sample.hpp"
#include "lbm/vreman.hpp"

namespace velum::cases {

/// A body on which a force is measured: its links, and the factors that make of the force on what
/// the box holds that on the whole body, where planes of symmetry cut it.
struct MeasuredBody {
  lbm::LinkList links;
  Vec3 whole;
};

/// A scene without a membrane, ready to march: the fluid, its walls, its openings and the bodies of
/// the force probes, in the order of the scene's probes.
template <class Real, class L = lbm::D2Q9, class Stored = Real>
struct FluidScene {
  Scene const* scene;
  LatticeScene<Real, L, Stored> lattice;
  lbm::LinkList resting;
  std::vector<MeasuredBody> bodies;
  std::optional<lbm::Vreman<Real>> vreman{};
  long steps = 0;
};

/// Steps for which Vreman's eddy viscosity is kept: an eddy takes more to pass a cell.
constexpr int vreman_every = 10;

/// Builds the scene in its initial state.
/// @param scene  must outlive the result
template <class Real, class L = lbm::D2Q9, class Stored = Real>
FluidScene<Real, L, Stored> make_fluid_scene(Scene const& scene, double smagorinsky);

/// One step: Vreman's eddy viscosity where it is due, ghosts, walls, sliding walls, openings, then
/// streaming and collision.
/// @param time  at the beginning of the step, s
template <class Real, class L, class Stored>
void step(FluidScene<Real, L, Stored>& s, double time);

/// The flow on the host, to be read between its cells.
template <class Real, class L, class Stored>
Sampled sampled(FluidScene<Real, L, Stored> const& s);

/// Force on the body of the k-th force probe in the step that comes next, SI (planar: per depth).
template <class Real, class L, class Stored>
Vec3 body_force(FluidScene<Real, L, Stored>& s, std::size_t k);

}  // namespace velum::cases
