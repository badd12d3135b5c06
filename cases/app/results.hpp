#pragma once
#include "cases/app/scene.hpp"

#include <filesystem>

namespace velum::cases {

/// Makes the results folder ready: creates it, proves that files can be written there, removes what
/// an earlier run left under velum's own file names, and writes the scene as run, scene.toml.
/// @throws core::InputError  the folder cannot be made or written, before anything is computed
void prepare_results(Scene const& scene, std::filesystem::path const& out);

}  // namespace velum::cases
