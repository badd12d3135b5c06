#pragma once
#include "cases/app/derived.hpp"

namespace velum::cases {

/// Area of a patch on a side of the box that no solid covers, in cells: of a plane scene the length,
/// about the axis weighed with its ring (core::ring). By samples in the middle of the cells beside
/// the side, 256 to a cell along a line, 8 x 8 in space.
double open_area(Scene const& scene, Derived const& d, Patch const& patch);

}  // namespace velum::cases
