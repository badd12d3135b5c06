#pragma once
#include "cases/app/body_scene.hpp"
#include "cases/app/simulation.hpp"

#include <variant>

namespace velum::cases {

/// What velum run takes: a scene with fluid or a membrane under pressure, or a body alone.
using AnyScene = std::variant<Scene, BodyScene>;

/// @throws core::InputError  one sentence with file, line, key, what is wrong and what is allowed
AnyScene read_any_scene(std::filesystem::path const& file,
                        std::vector<std::string> const& overrides);

std::string const& name_of(AnyScene const& scene);
SceneFile const& source_of(AnyScene const& scene);
/// Names of the files beside it that it reads, and of what velum plot marks if it is there.
std::vector<std::string> files_of(AnyScene const& scene);

/// Runs it to its end, its results in the folder; throws what run() does.
void run_any(AnyScene const& scene, RunOptions const& options);

}  // namespace velum::cases
