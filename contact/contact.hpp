#pragma once
#include "core/markers.hpp"
#include "core/obstacle.hpp"

#include <vector>

namespace velum::contact {

/// Frictionless contact between markers and a rigid obstacle.
struct Contact {
  core::Obstacle obstacle;
  double stiffness;                ///< k, pressure per length
  std::vector<double> multiplier;  ///< lambda per marker, pressure; empty: plain penalty
};

/// Symmetric 2 x 2 matrix, derivative of a force by a position.
struct SymmetricBlock {
  double xx = 0, xy = 0, yy = 0;
};

/// lambda of marker i, zero for plain penalty.
inline double multiplier_of(Contact const& c, std::size_t i)
{
  return c.multiplier.empty() ? 0 : c.multiplier[i];
}

/// How far the wet face of marker i is from the obstacle, distance(X) - offset: negative where it
/// penetrates.
double gap(Contact const& c, core::Markers const& markers, std::size_t i);

/// Adds the contact force, area x traction along the obstacle's normal, to F of each marker.
/// Areas and offsets are those of the markers, taken as constant.
void add_forces(Contact const& c, core::Markers& markers);

/// Where each marker was when its distance from the obstacle was last found. A distance changes by
/// no more than the way gone: until a marker may have come near, none has to be found.
struct Clearance {
  std::vector<core::Vec2> X;
  std::vector<double> distance;
};

/// The same without looking at markers that are out of reach; plain penalty only, else all are
/// looked at.
void add_forces(Contact const& c, core::Markers& markers, Clearance& clearance);

/// Derivative of each marker's force by its position, zero out of contact:
///   dF/dX = A (-k n n^T + t H),   H = kappa s s^T the curvature of the distance across n = s^perp.
/// kappa comes from normals a probe length to either side; probe = 0 leaves that term out.
/// @param blocks  resized   [markers]
void tangents(Contact const& c, core::Markers const& markers, double probe,
              std::vector<SymmetricBlock>& blocks);

}  // namespace velum::contact
