#pragma once
#include "contact/contact.hpp"
#include "contact/point_contact.hpp"
#include "contact/surface_contact.hpp"

namespace velum::contact {

/// Share of the way to the middle of a thickness that a step may go, unless told otherwise: four
/// steps or more then see a point on its way in.
constexpr double safe_share = 0.25;

/// Longest step in which no point moves by more than a share of what lies between it and the
/// solid, its own offset at least, so that none passes a thin wall unseen. Infinite at rest.
/// @param V  velocities of the points
double largest_safe_step(PointContact const& c, std::vector<core::Vec3> const& X,
                         std::vector<core::Vec3> const& V, double share = safe_share);

/// The same of markers, by their places and velocities, and an obstacle.
double largest_safe_step(Contact const& c, core::Markers const& markers, double share = safe_share);

/// Longest step in which no two places of the surfaces come nearer than a share of the least
/// thickness; their common motion does not count. Infinite at rest.
double largest_safe_step(SurfaceContact const& c, std::vector<core::Vec3> const& V,
                         double share = safe_share);

/// Least stiffness with which a face that comes with a speed stops within a depth, nothing else
/// holding it: rho_s h v^2 / depth^2. With the longest safe step of that speed and depth,
/// stable_stiffness() is 1 / (4 share^2) of it: 4 times as much.
inline double stopping_stiffness(double areal_mass, double speed, double depth)
{
  return areal_mass * speed * speed / (depth * depth);
}

}  // namespace velum::contact
