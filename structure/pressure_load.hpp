#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"

#include <vector>

namespace velum::structure {

enum class Side { plus, minus };

/// Pressure on a part of one face of one element, linear between its ends. Several may share an
/// element, so that a pressure may change at a point between nodes (the edge of a contact).
struct PressureSegment {
  int element;
  Side side;
  double from = 0, to = 1;  ///< place along the element: 0 at its first node, 1 at its last
  double p_from, p_to;      ///< pressure at the two places
};
using FacePressure = std::vector<PressureSegment>;

/// The same pressure on one whole face.
FacePressure uniform_pressure(Membrane const& m, Side side, double pressure);

/// Follower pressure: each segment pushes with -p n (plus side) or +p n (minus side) on the
/// deformed mid-surface, over its true ring area 2 pi y ds; handed to the element's two nodes by
/// their linear shape functions, integrated exactly by two Gauss points; tangent exact.
///
/// On the mid-surface, because a membrane feels the pressure jump there up to (thickness x
/// curvature)^2, and equal pressures on both sides cancel. Loading the two offset faces instead,
/// without the in-plane stress -p that goes with them, is wrong by pressure x thickness x
/// curvature.
/// @param m, pressure  kept by reference: must outlive the load; may change between calls
Load pressure_load(Membrane const& m, FacePressure const& pressure);

/// The same at the present positions: for a field that is 1 in a region of fluid and 0 elsewhere
/// the derivative of the region's volume by the positions.   [2N]
Eigen::VectorXd pressure_force(Membrane const& m, FacePressure const& pressure);

}  // namespace velum::structure
