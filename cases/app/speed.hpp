#pragma once
#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"

namespace velum::cases {

/// Million cell updates per second of the bulk fluid step on this machine, measured on a lattice of
/// the scene's size (at most 1e6 cells), collision and precision for about a third of a second.
/// Walls, openings and the membrane are not in it.
double measured_mlups(Scene const& scene, Derived const& derived);

}  // namespace velum::cases
