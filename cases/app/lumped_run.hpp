#pragma once
#include "cases/app/simulation.hpp"

namespace velum::cases {

/// The lumped fidelity: marches membrane, chambers and the gap's closure without a lattice, from
/// the hydrostatic state. Writes series.csv, profile.csv and summary.json.
void run_lumped(Scene const& scene, RunOptions const& options);

}  // namespace velum::cases
