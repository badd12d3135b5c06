#pragma once
#include "structure/material_test.hpp"

namespace velum::structure {

/// Drucker's stability of an incompressible sheet: whatever small strain comes on top, the stress
/// does work on it, dtau : dh > 0 with Kirchhoff stress and logarithmic strain h. With the
/// thickness free, tau = dW/dh, so that this is a positive definite second derivative of W(h1, h2).
/// Drucker, J. Appl. Mech. 26 (1959) 101; this form as in the manuals of finite-element programs.
bool is_stable(MooneyRivlin const& m, double l1, double l2);

struct StretchRange {
  double from, to;
};

/// The stretches around 1 between which a test is stable, as far as they were searched; empty
/// (1 to 1) where rest itself is unstable.
StretchRange stable_range(MooneyRivlin const& m, TestMode mode, StretchRange const& searched);

}  // namespace velum::structure
