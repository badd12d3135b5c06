#pragma once
#include "cases/app/scene.hpp"

namespace velum::cases {

/// How far an elastic disc lifts off a ring at the given radius when its boss is moved, over the
/// movement from 0 to `largest`: static equilibria of the clamped disc, bending as its thickness
/// wants, no pressure on it (the water follows, one way). Metres.
/// Throws core::Divergence where it finds none.
Curve pilot_lift(PilotMembrane const& pilot, Material const& material, double ring_radius,
                 double largest);

}  // namespace velum::cases
