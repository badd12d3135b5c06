#pragma once
#include "structure/membrane.hpp"

#include <Eigen/Core>

namespace velum::structure {

/// Largest stable step of the undamped explicit scheme, 2 / omega: omega^2 is bounded from above by
/// Gershgorin's circles of M^-1 K at the positions x (tight on a chain), to which each node's
/// contact stiffness over its mass is added. Damping and the blocks Z are implicit: they only
/// enlarge the true limit.
/// @param contact_stiffness  force per length, per node; empty: none   [N]
double stable_step(Membrane const& m, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   Eigen::VectorXd const& contact_stiffness = {});

/// Sub-steps of equal length that fit dt into the stable step with a margin.
int substeps_for(double dt, double stable, double margin = 0.8);

}  // namespace velum::structure
