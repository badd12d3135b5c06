#pragma once
#include <optional>
#include <vector>

#include "ibm/contact_load.hpp"
#include "ibm/loss.hpp"

namespace velum::ibm {

/// What the closure of a gap between membrane and seat needs to know.
struct GapLaw {
  Liquid liquid;
  double discharge = 0.7;  ///< of the narrowest place: its velocity head is lost behind it
  double seals_at;         ///< gap below which nothing flows: the roughness
};

/// Shape of the film between the minus face and the seat.
struct SeatGap {
  double least;                  ///< narrowest gap; 0 or less in contact
  int narrowest;                 ///< its node
  core::Vec2 at;                 ///< where that node's face is
  std::optional<Loss> loss;      ///< of a flow through it; empty: sealed
  double inertance;              ///< rho int ds / (2 pi r g) where g is below ten times the least
  std::vector<double> friction;  ///< share of the viscous loss at smaller radii than the node's [N]
  std::vector<double> narrowness;  ///< (least section / section at the node)^2                  [N]
};

/// Gap node by node and the loss of a flow along the face: lubrication, the gap linear between the
/// nodes,
///   dp = 12 rho nu Q int ds / (2 pi r g^3),
/// and the velocity head of the narrowest section 2 pi r g, over discharge^2.
/// Planar: per unit depth, 1 in the place of 2 pi r. The gap g is the distance of the minus face
/// from the seat, shifted by what makes the narrowest that of the contact, so that the flow begins
/// where the contact ends. The contact's own, distance of the mid-surface less half the thickness,
/// is right there alone: beside the land of a thick membrane it hardly grows.
/// @param seat  whose markers have been placed
SeatGap seat_gap(GapLaw const& law, SeatContact const& seat, structure::Membrane const& membrane);

/// Pressure at the nodes of the minus face as a share of the difference between outside (beyond the
/// narrowest place) and inside, for a flow Q through the gap: friction takes its part along the
/// film; the velocity head falls where the flow speeds up towards the narrowest place from outside
/// and is not won back behind it. From inside to outside the same mirrored. Of a sealed gap that
/// does not touch: friction alone.   [N], 0 inside, 1 outside
std::vector<double> outside_share(SeatGap const& gap, double Q);

}  // namespace velum::ibm
