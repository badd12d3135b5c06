#pragma once
#include "core/obstacle.hpp"
#include "core/signed_distance.hpp"

namespace velum::core {

/// Body of revolution in space: the profile turned about the line y = z = 0, its first coordinate
/// along x, its second the distance from that line. As exact as the profile's distance.
SignedDistance<3> revolved(Obstacle profile);

}  // namespace velum::core
