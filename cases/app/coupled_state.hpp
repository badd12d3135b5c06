#pragma once
#include "cases/app/coupled_scene.hpp"
#include "cases/app/measurement.hpp"
#include "core/output/state_file.hpp"

namespace velum::cases {

/// Writes the state of a sharp coupled scene, or reads it into one that was made from the same
/// scene file or one that differs in what drives it: populations, controls of the openings,
/// membrane with its stepper, contact, chambers, ledger. What follows from these (labels, links) is
/// rebuilt. A run that goes on from a state takes the same steps to the last bit as one that was
/// not interrupted, on the same back end with the same number of threads.
/// @param flows  sums of the run; with the ledger zeroed by restart_sums()
template <class Real>
void exchange_state(core::StateFile& file, CoupledScene<Real, ibm::Sharp>& s, Flows& flows);

/// Lets a branch count from its own beginning: flows and ledger from zero.
template <class Real>
void restart_sums(CoupledScene<Real, ibm::Sharp>& s, Flows& flows);

}  // namespace velum::cases
