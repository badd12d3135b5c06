#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "core/signed_distance.hpp"

namespace velum::contact {

/// Frictionless contact between points of a surface in space and a rigid solid.
struct PointContact {
  core::SignedDistance<3> solid;
  double stiffness;                ///< k, pressure per length
  double probe;                    ///< length over which the distance is differenced; small against
                                   ///< the solid's radii of curvature, large against round-off
  std::vector<double> area;        ///< that each point stands for
  std::vector<double> offset;      ///< of the wet face from the point: half the thickness
  std::vector<double> multiplier;  ///< lambda of each point, pressure; empty: plain penalty
};

/// How a point touches: gap distance(X) - offset (negative: penetrating), traction by penalty.hpp,
/// the solid's normal there.
struct Touch {
  double gap, traction;
  core::Vec3 normal;
};

/// lambda - k g: the traction where positive, minus the clearance (times k) where negative.
double pressing(PointContact const& c, std::size_t i, core::Vec3 const& X);

Touch touch(PointContact const& c, std::size_t i, core::Vec3 const& X);

/// Derivative of the point's force A t n by its position, zero out of contact:
///   A (-k n n^T + t H),   H the second derivatives of the distance: the turning of the normal.
std::array<std::array<double, 3>, 3> tangent(PointContact const& c, std::size_t i,
                                             core::Vec3 const& X);

/// Uzawa's update of all multipliers (augmented_lagrangian.hpp). Returns the largest change.
double update_multipliers(PointContact& c, std::vector<core::Vec3> const& X);

/// What touches in all.
struct ContactSum {
  double area = 0;             ///< of the points that touch
  core::Vec3 force = {};       ///< on the points
  double penetration = 0;      ///< the largest, 0 where nothing penetrates
  double largest = 0;          ///< traction
  double complementarity = 0;  ///< largest |t g| of the points that touch
};
ContactSum sum_up(PointContact const& c, std::vector<core::Vec3> const& X);

}  // namespace velum::contact
