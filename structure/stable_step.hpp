#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <Eigen/Core>

#include <span>

namespace velum::structure {

/// Largest stable step of the undamped explicit scheme for a body (a Membrane or a Sheet), 2 /
/// omega: omega^2 is bounded from above by Gershgorin's circles of M^-1 K at the positions x (tight
/// on a chain), with the tangents of the loads (bending, springs); to them each node's contact
/// stiffness over its mass is added. Damping and the blocks Z are implicit: they only enlarge the
/// true limit.
/// @param contact_stiffness  force per length, per node; empty: none   [N]
template <class Body>
double stable_step(Body const& body, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   std::span<Load const> loads = {}, Eigen::VectorXd const& contact_stiffness = {});

/// Sub-steps of equal length that fit dt into the stable step with a margin.
int substeps_for(double dt, double stable, double margin = 0.8);

}  // namespace velum::structure
