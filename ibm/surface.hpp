#pragma once
#include <vector>

#include "core/vec.hpp"
#include "structure/faces.hpp"

namespace velum::ibm {

/// One wet face as the lattice sees it: the polyline of the structure's face, continued past its
/// ends so that it divides the whole box. Segment s runs from points[s] to points[s + 1]; a place
/// on it at share t moves with (1 - t) node first[s] + t node second[s]. Lattice units.
struct FaceLine {
  std::vector<core::Vec2> points;
  std::vector<int> first, second;
};

/// The two wet faces of a membrane. Above the plus face (towards +x) lies the plus side, below the
/// minus face the minus side, between them the solid.
struct Surface {
  FaceLine plus, minus;
  structure::Faces faces;
  std::vector<double> thickening;  // half the rate of the thickness, averaged over some steps   [N]
};

/// Steps over which the rate of the thickness is averaged. The faces of an incompressible membrane
/// approach each other as it stretches; without that motion it would displace the wrong volume. The
/// rate enters the fluid one step late, so waves along the membrane must not be fed back through
/// it.
constexpr double thickening_memory = 50;

/// Places the faces of the membrane. At the axis the face goes on as its own mirror image; a
/// clamped rim goes straight on into the wall, so that a rim inside the wall cannot leak, wherever
/// the wall cuts the lattice. A call after the first takes one step to have passed since the last.
void locate(Surface& surface, structure::Membrane const& membrane);

}  // namespace velum::ibm
