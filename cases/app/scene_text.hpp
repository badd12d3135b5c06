#pragma once
#include "core/quantity.hpp"

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

/// Pieces of the sentences about a scene.
namespace velum::cases {

/// What a node is, in words.
std::string describe(toml::node const& node);

/// A value of that dimension as it is written.
std::string example(core::Dimension dimension);

/// "; did you mean "rubber"?" with the nearest word; empty where none is near.
std::string did_you_mean(std::string_view word, std::vector<std::string> const& words);

}  // namespace velum::cases
