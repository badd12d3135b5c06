#pragma once
#include "core/symmetry.hpp"

namespace velum::core {

/// SI value of one lattice unit of length (m), time (s) and density (kg/m3). Every other unit
/// follows, so that in lattice units cell size, time step and rest density are all 1.
struct Units {
  double dx, dt, rho;
};

// One pair of functions per quantity. The argument of to_lattice_* and the result of to_si_* are in
// the SI unit named beside the pair. What a body of revolution has per ring, a planar one has per
// metre of depth; these pairs take the symmetry.

double to_lattice_length(Units const& units, double si);  // m
double to_si_length(Units const& units, double lattice);

double to_lattice_time(Units const& units, double si);  // s
double to_si_time(Units const& units, double lattice);

double to_lattice_frequency(Units const& units, double si);  // 1/s
double to_si_frequency(Units const& units, double lattice);

double to_lattice_velocity(Units const& units, double si);  // m/s
double to_si_velocity(Units const& units, double lattice);

double to_lattice_acceleration(Units const& units, double si);  // m/s2 = N/kg
double to_si_acceleration(Units const& units, double lattice);

double to_lattice_density(Units const& units, double si);  // kg/m3
double to_si_density(Units const& units, double lattice);

/// Pressure, stress or elastic modulus. A pressure is counted from the rest state on both sides.
double to_lattice_pressure(Units const& units, double si);  // Pa
double to_si_pressure(Units const& units, double lattice);

double to_lattice_kinematic_viscosity(Units const& units, double si);  // m2/s
double to_si_kinematic_viscosity(Units const& units, double lattice);

/// Tension of a membrane: force per length of its edge, whatever the symmetry.
double to_lattice_tension(Units const& units, double si);  // N/m
double to_si_tension(Units const& units, double lattice);

double to_lattice_volume(Units const& units, Symmetry symmetry, double si);  // m3, planar m2
double to_si_volume(Units const& units, Symmetry symmetry, double lattice);

double to_lattice_flow_rate(Units const& units, Symmetry symmetry, double si);  // m3/s, planar m2/s
double to_si_flow_rate(Units const& units, Symmetry symmetry, double lattice);

double to_lattice_mass(Units const& units, Symmetry symmetry, double si);  // kg, planar kg/m
double to_si_mass(Units const& units, Symmetry symmetry, double lattice);

double to_lattice_force(Units const& units, Symmetry symmetry, double si);  // N, planar N/m
double to_si_force(Units const& units, Symmetry symmetry, double lattice);

double to_lattice_stiffness(Units const& units, Symmetry symmetry, double si);  // N/m, planar N/m2
double to_si_stiffness(Units const& units, Symmetry symmetry, double lattice);

double to_lattice_energy(Units const& units, Symmetry symmetry, double si);  // J, planar J/m
double to_si_energy(Units const& units, Symmetry symmetry, double lattice);

}  // namespace velum::core
