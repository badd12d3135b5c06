#pragma once
#include "core/quantity.hpp"

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Pieces of the sentences about a scene and other files.
namespace velum::cases {

/// The tables of a file.
/// @param what  the file should be, "scene file"
/// @throws core::InputError  there is no such file, or it is not TOML
toml::table parse_toml(std::filesystem::path const& file, std::string_view what);

/// What a node is, in words.
std::string describe(toml::node const& node);

/// A value of that dimension as it is written.
std::string example(core::Dimension dimension);

/// "; did you mean "rubber"?" with the nearest word; empty where none is near.
std::string did_you_mean(std::string_view word, std::vector<std::string> const& words);

}  // namespace velum::cases
