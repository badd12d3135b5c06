#pragma once
#include "cases/app/simulation.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// Marches a scene without a membrane: fluid between rigid walls. Ends at run.end, or before where
/// the flow has become steady (cases/app/steady.hpp).
/// @param options  with an empty folder nothing is written and nothing said
/// @return the figures of its end and the errors against its reference, with its assumptions
/// Throws core::InputError, core::Divergence or Stopped.
core::Summary march_fluid(Scene const& scene, RunOptions const& options);

/// The same with its summary written and said: fields, the flow and traction of every boundary and
/// the probes over time, summary.json.
void run_fluid(Scene const& scene, RunOptions const& options);

}  // namespace velum::cases
