#pragma once
#include <span>

#include "contact/safe_step.hpp"
#include "structure/load.hpp"
#include "structure/sheet.hpp"

namespace velum::ibm {

/// Longest sub-step of the explicit scheme for a sheet in contact: four fifths of the stable one
/// (structure/stable_step.hpp); no longer than omega dt = 1/2 of a node on the contact, whether it
/// touches or not, since a bounce in fewer steps may gain energy; and safe (contact/safe_step.hpp).
/// @param mass   lumped, per node
/// @param loads  whatever else has a tangent, such as bending
double contact_step(structure::Sheet const& s, Eigen::VectorXd const& mass,
                    contact::PointContact const& c, std::span<structure::Load const> loads = {});
double contact_step(structure::Sheet const& s, Eigen::VectorXd const& mass,
                    contact::SurfaceContact const& c, std::span<structure::Load const> loads = {});

}  // namespace velum::ibm
