#pragma once
#include <filesystem>

namespace velum::core {

/// How much of the log reaches the console; the file always gets everything.
enum class Console { normal, quiet };

/// Sends spdlog's default logger to the console (text only; quiet: warnings and errors only) and to
/// `folder`/log.txt (with date and level, written through at every line). Log with spdlog::info()
/// and its like; before this call they reach the console alone.
/// @param append  goes on with the log of an earlier run
/// @throws InputError  the file cannot be written
void start_log(std::filesystem::path const& folder, Console console, bool append = false);

}  // namespace velum::core
