#pragma once
#include <string>

#include "cases/app/coupled_state.hpp"
#include "cases/app/simulation.hpp"

namespace velum::cases {

/// The scene that a run begins as: that of [start], or the scene itself.
/// @param overrides  of the run, applied to the other scene too
/// @throws core::InputError  the other one differs in more than what drives it
Scene initial_scene(Scene const& scene, std::vector<std::string> const& overrides);

/// Hexadecimal name of the state that a scene reaches after `settle` seconds with all that drives
/// it held as it is at t = 0: a hash (FNV-1a, 64 bit) of version, time step and of the scene as
/// run, files included, without what does not bear on that state. Scenes that differ only later
/// share it.
std::string state_name(Scene const& initial, double settle);

/// Membrane, spring and seat as the initial scene begins: in equilibrium where there is a seat.
HydrostaticScene make_start(Scene const& initial);

/// A scene ready to march from the state that `initial` has settled to. The state is kept in
/// states/<name>.h5 beside the results folder; where it is there already, it is taken.
template <class Real>
CoupledScene<Real, ibm::Sharp> make_settled_scene(Scene const& scene, Scene const& initial,
                                                  HydrostaticScene& start, double smagorinsky,
                                                  RunOptions const& options);

}  // namespace velum::cases
