#pragma once
#include <algorithm>

namespace velum::contact {

/// Normal traction of a point at gap g (negative: penetrating):
///   t = max(0, lambda - k g).
/// With lambda = 0 it is the penalty law t = k <-g>, penetrating by p / k under a pressure p; with
/// the multiplier of augmented_lagrangian.hpp it is the augmented Lagrangian's (Wriggers,
/// Computational Contact Mechanics (2006), section 6.3).
/// @param k  pressure / length;  @param lambda  pressure
inline double traction(double k, double g, double lambda) { return std::max(0.0, lambda - k * g); }

/// Penalty stiffness that stays explicitly stable with a margin: a free mass on it has omega dt =
/// 1/2, a quarter of the limit, which leaves room for the membrane's own stiffness.
/// @param areal_mass  rho_s h;  @param dt  the step (sub-step) the contact force is taken with
inline double stable_stiffness(double areal_mass, double dt)
{
  return 0.25 * areal_mass / (dt * dt);
}

}  // namespace velum::contact
