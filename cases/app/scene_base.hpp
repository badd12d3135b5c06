#pragma once
#include <toml++/toml.h>

#include <filesystem>

namespace velum::cases {

/// The tables of a scene file; where it names a `base`, a scene file beside it, those of the base
/// with its own put over them: tables are merged key by key, everything else is replaced. Each node
/// keeps the file and line that it came from; `base` itself is dropped.
/// @throws core::InputError  a file is missing or not TOML, or is a base of itself
toml::table read_tables(std::filesystem::path const& file);

}  // namespace velum::cases
