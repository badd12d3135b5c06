#pragma once
#include "cases/app/derived.hpp"
#include "lbm/observe.hpp"

namespace velum::cases {

/// Steps between two looks at the whole fluid; a look costs about as much as a step.
constexpr long guard_every = 100;

/// Throws core::Divergence with step, time, cell, place and likely cause when the fluid has left
/// the range of the method: not finite, faster than its sound, or density off by half.
void guard_fluid(Derived const& derived, lbm::Observation const& seen, long step);

}  // namespace velum::cases
