#pragma once
#include "core/symmetry.hpp"
#include "ibm/surface.hpp"

namespace velum::ibm {

/// The part of a plane in which a face meets fluid: rows from y = lowest to y = highest.
struct Rows {
  double lowest, highest;
};

/// Volume that segment s of a face has swept between two places of it, positive towards the plus
/// side: of the quadrangle between the old and the new segment, turned about the axis where there
/// is one. Summed over a face it is the change of the volume below the face, to round-off, whatever
/// way it went: an integral of the velocity over the links is not.
double swept_volume(FaceLine const& before, FaceLine const& after, std::size_t s, Rows rows,
                    core::Symmetry symmetry);

}  // namespace velum::ibm
