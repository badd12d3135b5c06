#pragma once
#include "cases/app/hydrostatic_scene.hpp"
#include "cases/app/pressure_network.hpp"
#include "ibm/lumped.hpp"

namespace velum::cases {

/// A scene with its membrane between lumped volumes, ready to march; lattice units.
struct LumpedScene {
  Derived derived;
  NetworkKey key;
  ibm::Lumped state;
  std::optional<structure::LiftStop> stop{};
};

/// The membrane in its hydrostatic state, the regions below it joined to inlet and outlet by the
/// openings' areas: the outlet's velocity head is lost, both columns of liquid have their inertia.
/// Where the scene has no chamber above, what is there hangs on the inlet too.
LumpedScene make_lumped_scene(Scene const& scene, Derived const& derived,
                              HydrostaticScene const& start);

/// Volume per step that leaves through the outlet, with what the orifices bring there.
double outflow(LumpedScene const& s);

}  // namespace velum::cases
