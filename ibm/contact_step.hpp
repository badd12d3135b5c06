#pragma once
#include <span>

#include "contact/safe_step.hpp"
#include "ibm/contact_load.hpp"
#include "structure/load.hpp"
#include "structure/sheet.hpp"

namespace velum::ibm {

/// Longest sub-step of the explicit scheme for a body in contact: four fifths of the stable one
/// (structure/stable_step.hpp); no longer than omega dt = 1/2 of a node on the contact, whether it
/// touches or not, since a bounce in fewer steps may gain energy; and safe (contact/safe_step.hpp).
/// @param mass   lumped, per node
/// @param loads  whatever else has a tangent, such as bending
double contact_step(structure::Membrane const& m, Eigen::VectorXd const& mass, SeatContact const& c,
                    std::span<structure::Load const> loads = {});
double contact_step(structure::Sheet const& s, Eigen::VectorXd const& mass,
                    contact::PointContact const& c, std::span<structure::Load const> loads = {});
double contact_step(structure::Sheet const& s, Eigen::VectorXd const& mass,
                    contact::SurfaceContact const& c, std::span<structure::Load const> loads = {});

/// Longest step in which no node at x with velocity v moves by more than a share of what lies
/// between it and the seat, its half thickness at least. With a displacement in place of v: at
/// least 1 where it was no longer than that.   x, v: [2N or 3N]
double safe_step(SeatContact const& c, Eigen::VectorXd const& x, Eigen::VectorXd const& v,
                 double share = contact::safe_share);
double safe_step(contact::PointContact const& c, Eigen::VectorXd const& x, Eigen::VectorXd const& v,
                 double share = contact::safe_share);

}  // namespace velum::ibm
