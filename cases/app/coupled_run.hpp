#pragma once
#include "cases/app/simulation.hpp"

namespace velum::cases {

/// Marches fluid and membrane together through the stages of the scene: `settle` with the
/// boundaries as given, then `shut` with the inlets shut. Starts from the hydrostatic state where
/// there is a seat. Writes run.h5, run.xmf, series.csv and summary.json.
void run_coupled(Scene const& scene, RunOptions const& options);

}  // namespace velum::cases
