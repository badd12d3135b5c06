#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"

namespace velum::structure {

/// Elastic energy at the positions x: the sum over elements of the membrane energy. Bending, where
/// a membrane has it, is one more term of this sum, its gradient and its tangent.
double elastic_energy(Membrane const& m, Eigen::VectorXd const& x);

/// Subtracts the gradient of the elastic energy from force: adds what the elements do to the nodes.
void add_elastic_force(Membrane const& m, Eigen::VectorXd const& x, Eigen::VectorXd& force);

/// Adds the second derivatives of the elastic energy (stiffness: minus dF/dx).
void add_stiffness(Membrane const& m, Eigen::VectorXd const& x, Triplets& stiffness);

/// Nodal force that round-off of the positions alone can make: no solver balances forces better.
double rounding_force(Membrane const& m, Eigen::VectorXd const& x);

/// Largest of all meridional and hoop stretches.
double largest_stretch(Membrane const& m, Eigen::VectorXd const& x);

}  // namespace velum::structure
