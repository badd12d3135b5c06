#pragma once
#include "cases/app/scene.hpp"

namespace velum::cases {

/// Refuses a scene whose sections do not fit together: names without owner, a membrane outside the
/// domain or without hold, a boundary on a closed wall.
/// @throws core::InputError  one sentence with place and key
void check_scene(Scene const& scene);

}  // namespace velum::cases
