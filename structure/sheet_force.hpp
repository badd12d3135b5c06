#pragma once
#include "structure/load.hpp"
#include "structure/sheet.hpp"

namespace velum::structure {

/// The same for a sheet as for a line membrane (internal_force.hpp, mass.hpp).
double elastic_energy(Sheet const& s, Eigen::VectorXd const& x);
void add_elastic_force(Sheet const& s, Eigen::VectorXd const& x, Eigen::VectorXd& force);
void add_stiffness(Sheet const& s, Eigen::VectorXd const& x, Triplets& stiffness);
double rounding_force(Sheet const& s, Eigen::VectorXd const& x);
double largest_stretch(Sheet const& s, Eigen::VectorXd const& x);

/// A third of the undeformed area, or mass, of the triangles around each node.   [N]
Eigen::VectorXd nodal_area(Sheet const& s);
Eigen::VectorXd lumped_mass(Sheet const& s);

/// Current thickness at the nodes, of a solid that keeps its volume: the mean over the triangles
/// around each, weighted with their undeformed area.   [N]
Eigen::VectorXd nodal_thickness(Sheet const& s, Eigen::VectorXd const& x);

/// Consistent mass: density times the integral of N_a N_b over the undeformed volume.   [3N][3N]
Triplets consistent_mass(Sheet const& s);

double kinetic_energy(Sheet const& s, Eigen::VectorXd const& mass);

}  // namespace velum::structure
