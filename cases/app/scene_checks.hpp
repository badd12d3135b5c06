#pragma once
#include "cases/app/scene.hpp"

namespace velum::cases {

/// Refuses a scene whose sections do not fit together: names without owner, a membrane outside the
/// domain or without hold, a boundary on a closed wall.
/// @throws core::InputError  one sentence with place and key
void check_scene(Scene const& scene);

/// The part of check_scene() about what only a flow without membrane has: periodic sides, moving
/// walls, initial flow, probes, reference, chart.
void check_flow(Scene const& scene);

/// The part about chambers, orifices, ports and what the lumped fidelity needs.
void check_network(Scene const& scene);

/// Whether a run marches fluid and membrane together with a membrane whose state can be kept: then
/// it writes checkpoints and may begin with [start].
bool can_be_kept(Scene const& scene);

/// The part about how a run begins and is kept: [start], run.checkpoint_every.
void check_march(Scene const& scene);

/// Throws core::InputError where the scene has no material of that name.
void check_material(Scene const& scene, std::string const& key, std::string const& name);

/// Throws core::InputError: the name under the key names nothing of that kind; says the nearest one
/// or all that are known.
[[noreturn]] void reject_name(Scene const& scene, std::string const& key, std::string const& name,
                              std::string const& kind, std::vector<std::string> const& known);

}  // namespace velum::cases
