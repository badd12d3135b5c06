#pragma once
#include "cases/app/coupled_state.hpp"

namespace velum::cases {

/// Factor on the time step when a run falls back.
constexpr double fall_back_share = 0.7;

/// The scene with its time step, or lattice.mach that sets it, shorter by that factor, so many
/// times.
Scene slower(Scene scene, long times = 1);

/// Gives `to`, made from a slower scene, the state of `from`, the same in SI units. With
/// r = dt'/dt lengths, masses and volumes stay, velocities and flows take r, pressures, densities
/// over that at rest and accelerations r^2. Populations are the equilibrium of the new density and
/// velocity with what the old ones were beside theirs, times
///   r (tau' - 1) / (tau - 1),
/// for after a collision that part is (1 - 1/tau) tau times the rate of strain (of the lattice's
/// own viscosity; an eddy viscosity finds itself within a few steps). What depends on the lattice's
/// speed of sound is another one afterwards: openings that let sound out resist a change of the
/// flow by rho c_s U, so that pressures in motion go over to those of the shorter step within a
/// passage of sound.
/// @param flows  sums of the run, whose counts of steps become those of `to`
template <class Real>
void carry_over(CoupledScene<Real, ibm::Sharp> const& from, CoupledScene<Real, ibm::Sharp>& to,
                Flows& flows);

}  // namespace velum::cases
