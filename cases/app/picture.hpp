#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace velum::cases {

/// Runs a script of cases/plot on a folder, which draws its picture there. Where that fails (no
/// Python, no matplotlib, no script) a warning says how to draw it elsewhere; the data stay.
/// Python is $PYTHON or /usr/bin/python3, the scripts lie in $VELUM_PLOT or the source tree.
/// @param more  words for the script, behind the folder
void draw(std::string const& script, std::filesystem::path const& folder,
          std::vector<std::string> const& more = {});

}  // namespace velum::cases
