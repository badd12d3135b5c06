#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace velum::cases {

/// Where a script of cases/plot lies: in $VELUM_PLOT or the source tree.
std::filesystem::path plot_script(std::string const& name);

/// What an environment variable says, or otherwise where it is unset or empty.
std::string setting(char const* variable, char const* otherwise);

enum class Voice { heard, silent };

/// Runs a program, found by its name in the path, to its end; true when it says that all went well.
bool succeeds(std::vector<std::string> words, Voice voice);

}  // namespace velum::cases
