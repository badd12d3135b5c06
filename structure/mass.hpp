#pragma once
#include "structure/membrane.hpp"

#include <Eigen/Core>

namespace velum::structure {

/// Reference area that belongs to each node: integral of its linear shape function over the ring
/// 2 pi Y ds (or per unit depth). On the axis it is pi L^2 / 3, so no node is without area.   [N]
Eigen::VectorXd nodal_area(Membrane const& m);

/// Lumped mass of each node: density times the undeformed volume under its shape function.   [N]
Eigen::VectorXd lumped_mass(Membrane const& m);

/// Kinetic energy of the lumped masses.
double kinetic_energy(Membrane const& m, Eigen::VectorXd const& mass);

}  // namespace velum::structure
