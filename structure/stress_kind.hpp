#pragma once
#include "structure/material_test.hpp"

#include <optional>

namespace velum::structure {

/// Relative residuals of a test with its stresses taken as engineering and as true.
struct KindMisfit {
  double engineering, true_;
};

/// How well the stresses of one test fit rubber if they are of either kind. Rubber is here c10 and
/// c01 with 0 <= c01 <= c10, as Mooney found it, and stretches up to 2.5, beyond which chains of
/// finite length stiffen it; without the bounds a wrong kind can hide in a negative or a large c01,
/// since l - l^-2 taken for a true stress is a pure c01. In equibiaxial tension, where c01 grows as
/// l^3, the two kinds come apart only at stretches of 2 and more.
/// @return nothing where fewer than 5 points are left
std::optional<KindMisfit> misfit_by_kind(MaterialTest const& test);

/// True where the stresses fit rubber far better as the other kind than as the one they are said to
/// be of: with residuals less than half as large.
bool looks_like_the_other_kind(MaterialTest const& test);

}  // namespace velum::structure
