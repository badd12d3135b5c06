#pragma once
#include "cases/app/body_output.hpp"
#include "cases/app/material_range.hpp"

namespace velum::cases {

/// Marches a body under the pressure of the scene from rest, and notes its states.
/// @param said  gets which scheme was chosen and why
/// @throws core::Divergence  with the time at which the motion is lost
template <class Body>
BodyResult march(BodyScene const& scene, BodyModel<Body>& model, BodyOutput& out,
                 StretchRecord& stretch, std::string& said);

}  // namespace velum::cases
