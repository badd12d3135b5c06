#pragma once
#include "cases/app/fit_study.hpp"

namespace velum::cases {

/// What to beware of, a sentence each: stresses that look like the other kind, laws that are
/// unstable within what was fitted, laws of several parameters that rest on one kind of test.
std::vector<std::string> warnings(FitStudy const& study);

}  // namespace velum::cases
