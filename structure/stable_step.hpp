#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <Eigen/Core>

#include <span>

namespace velum::structure {

/// Largest stable step of the undamped explicit scheme, 2 / omega: omega^2 is bounded from above by
/// Gershgorin's circles of M^-1 K at the positions x (tight on a chain), to which each node's
/// contact stiffness over its mass is added. Damping and the blocks Z are implicit: they only
/// enlarge the true limit.
/// @param contact_stiffness  force per length, per node; empty: none   [N]
double stable_step(Membrane const& m, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   Eigen::VectorXd const& contact_stiffness = {});

/// The same for a sheet and what else acts on it with a tangent (bending, contact), on the
/// assembled matrix.
double stable_step(Sheet const& s, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   std::span<Load const> loads = {});

/// Sub-steps of equal length that fit dt into the stable step with a margin.
int substeps_for(double dt, double stable, double margin = 0.8);

}  // namespace velum::structure
