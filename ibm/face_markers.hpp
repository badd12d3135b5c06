#pragma once
#include <vector>

#include "core/symmetry.hpp"
#include "ibm/surface.hpp"

namespace velum::ibm {

/// A piece of a wet face that acts on the fluid at one point. Lattice units.
struct FaceMarker {
  core::Vec2 X;
  core::Vec2 outward;  // unit normal, out of the membrane
  core::Vec2 drift;    // velocity against the mid-surface, from the changing thickness
  double area;         // of its whole ring, or per unit depth
  int first, second;   // nodes it moves with, and the share of the second
  double share;
  bool plus;  // lies on the plus face
};

/// Markers of both faces, the plus face first, in the order of the nodes. Each segment of a face is
/// divided evenly; as it stretches it gets a further marker whenever they stand more than 1.25
/// cells apart, and keeps it: numbers that came and went would be heard in the force.
struct FaceMarkers {
  std::vector<FaceMarker> list;
  std::vector<int> per_segment[2];  // of the plus and the minus face [N-1]
};

/// Places the markers on the faces.
void place(FaceMarkers& markers, Surface const& surface, core::Symmetry symmetry);

}  // namespace velum::ibm
