#pragma once
#include "cases/app/scene.hpp"
#include "lbm/fluid.hpp"
#include "lbm/link.hpp"

#include <vector>

namespace velum::cases {

/// Gives the links of an opening the shape of its velocity over a patch: 4 s (1 - s) with s from 0
/// to 1 across the patch, in space the product over both coordinates; 1 - (r/R)^2 on a disc, and
/// where an axisymmetric patch starts on the axis. It is scaled so
/// that its mean over the area of the links, weighted as lbm::opening_area does, is 1: the flow
/// through the patch is exactly mean velocity times area, on every grid.
/// @param patch   its range, lattice units
/// @param at      where each link meets the patch, along it, lattice units       [links]
/// @param normal  into the fluid
template <class Real, class L, class Stored>
void shape_velocity(lbm::Fluid<Real, L, Stored> const& fluid, VelocityProfile profile,
                    Patch const& patch, std::vector<Vec2> const& at, Vec3 normal,
                    std::vector<lbm::Link>& links);

}  // namespace velum::cases
