#pragma once
#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// Smagorinsky's constant that a run uses, 0 for off. "auto" is off where the seat is sealed: fluid
/// at rest has nothing to act on.
double smagorinsky_constant(Scene const& scene, bool sealed);

/// What a run assumes and chose by itself, in words; printed at its start, kept with its result.
core::Assumptions assumptions(Scene const& scene, Derived const& derived, double smagorinsky);

}  // namespace velum::cases
