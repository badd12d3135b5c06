#pragma once
#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// Smagorinsky's constant that a run uses, 0 for off. "auto" is off where the seat is sealed: fluid
/// at rest has nothing to act on.
double smagorinsky_constant(Scene const& scene, bool sealed);

/// Whether a body of this thickness over span bends, and why.
/// @param rim  the word for how its rim is held
std::string bending_in_words(Bending asked, bool on, double slenderness, std::string const& rim);

/// What a run assumes and chose by itself, in words; printed at its start, kept with its result.
core::Assumptions assumptions(Scene const& scene, Derived const& derived, double smagorinsky);

}  // namespace velum::cases
