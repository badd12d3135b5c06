#include "core/units.hpp"

namespace velum::core {
namespace {

// SI value of one lattice unit of each quantity. u: Units, s: Symmetry.

double square(double a) { return a * a; }

/// A ring's circumference and the third axis of space are lengths; planar quantities are per metre
/// of depth.
double depth(Units const& u, Symmetry s) { return s == Symmetry::planar ? 1 : u.dx; }

double length(Units const& u) { return u.dx; }
double time(Units const& u) { return u.dt; }
double frequency(Units const& u) { return 1 / u.dt; }
double velocity(Units const& u) { return u.dx / u.dt; }
double acceleration(Units const& u) { return u.dx / (u.dt * u.dt); }
double density(Units const& u) { return u.rho; }
double pressure(Units const& u) { return u.rho * square(u.dx / u.dt); }
double kinematic_viscosity(Units const& u) { return u.dx * u.dx / u.dt; }
double tension(Units const& u) { return pressure(u) * u.dx; }
double volume(Units const& u, Symmetry s) { return u.dx * u.dx * depth(u, s); }
double flow_rate(Units const& u, Symmetry s) { return volume(u, s) / u.dt; }
double mass(Units const& u, Symmetry s) { return u.rho * volume(u, s); }
double force(Units const& u, Symmetry s) { return pressure(u) * u.dx * depth(u, s); }
double stiffness(Units const& u, Symmetry s) { return pressure(u) * depth(u, s); }
double energy(Units const& u, Symmetry s) { return force(u, s) * u.dx; }

}  // namespace

double to_lattice_length(Units const& u, double si) { return si / length(u); }
double to_si_length(Units const& u, double lattice) { return lattice * length(u); }

double to_lattice_time(Units const& u, double si) { return si / time(u); }
double to_si_time(Units const& u, double lattice) { return lattice * time(u); }

double to_lattice_frequency(Units const& u, double si) { return si / frequency(u); }
double to_si_frequency(Units const& u, double lattice) { return lattice * frequency(u); }

double to_lattice_velocity(Units const& u, double si) { return si / velocity(u); }
double to_si_velocity(Units const& u, double lattice) { return lattice * velocity(u); }

double to_lattice_acceleration(Units const& u, double si) { return si / acceleration(u); }
double to_si_acceleration(Units const& u, double lattice) { return lattice * acceleration(u); }

double to_lattice_density(Units const& u, double si) { return si / density(u); }
double to_si_density(Units const& u, double lattice) { return lattice * density(u); }

double to_lattice_pressure(Units const& u, double si) { return si / pressure(u); }
double to_si_pressure(Units const& u, double lattice) { return lattice * pressure(u); }

double to_lattice_kinematic_viscosity(Units const& u, double si)
{
  return si / kinematic_viscosity(u);
}

double to_si_kinematic_viscosity(Units const& u, double lattice)
{
  return lattice * kinematic_viscosity(u);
}

double to_lattice_tension(Units const& u, double si) { return si / tension(u); }
double to_si_tension(Units const& u, double lattice) { return lattice * tension(u); }

double to_lattice_volume(Units const& u, Symmetry s, double si) { return si / volume(u, s); }
double to_si_volume(Units const& u, Symmetry s, double lattice) { return lattice * volume(u, s); }

double to_lattice_flow_rate(Units const& u, Symmetry s, double si) { return si / flow_rate(u, s); }
double to_si_flow_rate(Units const& u, Symmetry s, double lattice)
{
  return lattice * flow_rate(u, s);
}

double to_lattice_mass(Units const& u, Symmetry s, double si) { return si / mass(u, s); }
double to_si_mass(Units const& u, Symmetry s, double lattice) { return lattice * mass(u, s); }

double to_lattice_force(Units const& u, Symmetry s, double si) { return si / force(u, s); }
double to_si_force(Units const& u, Symmetry s, double lattice) { return lattice * force(u, s); }

double to_lattice_stiffness(Units const& u, Symmetry s, double si) { return si / stiffness(u, s); }
double to_si_stiffness(Units const& u, Symmetry s, double lattice)
{
  return lattice * stiffness(u, s);
}

double to_lattice_energy(Units const& u, Symmetry s, double si) { return si / energy(u, s); }
double to_si_energy(Units const& u, Symmetry s, double lattice) { return lattice * energy(u, s); }

}  // namespace velum::core
