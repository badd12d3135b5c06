#pragma once
#include <filesystem>
#include <string_view>

namespace velum::core {

/// Makes the folder of a run, with its parents, and tries to write in it.
/// @return its absolute path
/// @throws InputError  it cannot be made or written
std::filesystem::path make_folder(std::filesystem::path const& folder);

/// Replaces a file at once (written beside it and renamed): readers see the old text or the new
/// one, never a part.
/// @throws InputError  it cannot be written
void write_atomically(std::filesystem::path const& file, std::string_view text);

}  // namespace velum::core
