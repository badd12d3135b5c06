#pragma once
#include "cases/app/simulation.hpp"

namespace velum::cases {

/// Marches a scene without a membrane: fluid between rigid walls. Writes the fields, the flow and
/// traction of every boundary over time, and a summary.
void run_fluid(Scene const& scene, RunOptions const& options);

}  // namespace velum::cases
