#pragma once
#include "cases/app/scene.hpp"

#include <filesystem>

namespace velum::cases {

/// Makes the results folder ready: creates it, proves that files can be written there, removes what
/// an earlier run left under velum's own file names, and writes the scene as run, scene.toml, with
/// the files that it names.
/// @param restart  checkpoint that the run goes on from, or empty: with one nothing is removed, and
///                 what the earlier run left beside it is copied where `out` is another folder
/// @throws core::InputError  the folder cannot be made or written, before anything is computed
void prepare_results(SceneFile const& source, std::vector<std::string> const& files,
                     std::filesystem::path const& out, std::filesystem::path const& restart = {});

/// Whether a folder was made ready for this very scene: its scene.toml, and beside it the files
/// that it names, are the same to the last byte.
bool is_of_scene(std::filesystem::path const& out, SceneFile const& source,
                 std::vector<std::string> const& files);

/// Names of the files beside a scene that it reads.
/// @param others  besides those of solids and materials; empty names count for none
std::vector<std::string> files_of(std::vector<Solid> const& solids,
                                  std::map<std::string, Material> const& materials,
                                  std::vector<std::string> others);

}  // namespace velum::cases
