#pragma once
#include "structure/membrane.hpp"
#include "structure/sheet_bending.hpp"

namespace velum::structure {

/// Largest stretch along the meridian in either face of a chain that bends. At a node the faces
/// have that of the mid-surface, mean of the elements beside it, and what the turn from one to the
/// other adds at H/2 from it (Kirchhoff; H undeformed),
///   l = l1 + (H/2) angle / L,   L the undeformed length between the middles of the elements;
/// at a clamped end, against the undeformed slope, over half an element. Second order in the size
/// of elements, first at such ends.
/// @param rim  how ends whose node is held may turn
double largest_face_stretch(Membrane const& m, Rim rim);

}  // namespace velum::structure
