#pragma once
#include <toml++/toml.h>

#include <string>

namespace velum::cases {

/// Puts one "key.path=value" of the command line into a scene. The path may count into arrays,
/// inlet.patches[0].from. The value is TOML, or the bare text that a shell leaves of it:
/// 300 kPa, [25 um, 0 um], true, 0.1.
/// @return the key
/// @throws core::InputError  no '=', a path through a value, or into a solid, material, boundary
///                           or probe that the scene does not have
std::string apply_override(toml::table& scene, std::string const& text);

}  // namespace velum::cases
