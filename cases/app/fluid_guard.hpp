#pragma once
#include <string>

#include "cases/app/derived.hpp"
#include "lbm/observe.hpp"

namespace velum::cases {

/// Steps between two looks at the whole fluid; a look costs about as much as a step.
constexpr long guard_every = 100;

/// What has left the range of the method, in words: not finite, faster than its sound, density off
/// by half, or 16-bit storage at the end of its range; empty where all is well.
std::string fault(lbm::Observation const& seen);

/// Throws core::Divergence with the fault, step, time, cell, place and likely cause.
[[noreturn]] void diverge(Derived const& derived, std::string const& fault,
                          lbm::CellPlace const& worst, long step);

}  // namespace velum::cases
