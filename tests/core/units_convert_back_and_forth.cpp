#include "core/units.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

using namespace core;

Units const units{4e-5, 7e-8, 998.2};
constexpr auto ring_body = Symmetry::axisymmetric, plane_body = Symmetry::planar;

/// Both ways: relative error of a round trip below two roundings.
template <class ToLattice, class ToSi>
void expect_inverse(ToLattice to_lattice, ToSi to_si)
{
  for (double const value : {1e-9, -0.37, 1.0, 2.5e8})
    EXPECT_DOUBLE_EQ(to_si(to_lattice(value)), value);
}

TEST(Units, every_pair_of_functions_is_a_pair_of_inverses)
{
  using Pair = double (*)(Units const&, double);
  for (auto const& [to_lattice, to_si] : {
           std::pair<Pair, Pair>{to_lattice_length, to_si_length},
           {to_lattice_time, to_si_time},
           {to_lattice_frequency, to_si_frequency},
           {to_lattice_velocity, to_si_velocity},
           {to_lattice_acceleration, to_si_acceleration},
           {to_lattice_density, to_si_density},
           {to_lattice_pressure, to_si_pressure},
           {to_lattice_kinematic_viscosity, to_si_kinematic_viscosity},
           {to_lattice_tension, to_si_tension},
       })
    expect_inverse([&](double si) { return to_lattice(units, si); },
                   [&](double lattice) { return to_si(units, lattice); });

  using BodyPair = double (*)(Units const&, Symmetry, double);
  for (auto const& [to_lattice, to_si] : {
           std::pair<BodyPair, BodyPair>{to_lattice_volume, to_si_volume},
           {to_lattice_flow_rate, to_si_flow_rate},
           {to_lattice_mass, to_si_mass},
           {to_lattice_force, to_si_force},
           {to_lattice_stiffness, to_si_stiffness},
           {to_lattice_energy, to_si_energy},
       })
    for (Symmetry const s : {ring_body, plane_body})
      expect_inverse([&](double si) { return to_lattice(units, s, si); },
                     [&](double lattice) { return to_si(units, s, lattice); });
}

TEST(Units, the_lattice_has_unit_cell_step_and_density)
{
  EXPECT_DOUBLE_EQ(to_lattice_length(units, units.dx), 1);
  EXPECT_DOUBLE_EQ(to_lattice_time(units, units.dt), 1);
  EXPECT_DOUBLE_EQ(to_lattice_density(units, units.rho), 1);
}

/// Physical laws hold among converted numbers exactly as among SI ones: the SI values on the left
/// are products of those on the right, and so must be the lattice values.
TEST(Units, laws_hold_in_lattice_numbers)
{
  double const rho = 1140, u = 0.8, length = 3e-3, time = 2e-4, a = 9.81, nu = 1e-6;
  double const l = to_lattice_length(units, length), t = to_lattice_time(units, time);
  double const v = to_lattice_velocity(units, u), r = to_lattice_density(units, rho);

  EXPECT_DOUBLE_EQ(to_lattice_velocity(units, length / time), l / t);
  EXPECT_DOUBLE_EQ(to_lattice_frequency(units, 1 / time), 1 / t);
  EXPECT_DOUBLE_EQ(to_lattice_pressure(units, rho * u * u), r * v * v);  // stagnation
  EXPECT_DOUBLE_EQ(u * length / nu, v * l / to_lattice_kinematic_viscosity(units, nu));  // Re
  EXPECT_DOUBLE_EQ(to_lattice_tension(units, rho * u * u * length), r * v * v * l);
  EXPECT_DOUBLE_EQ(to_lattice_acceleration(units, a), to_lattice_velocity(units, a * time) / t);

  for (Symmetry const s : {ring_body, plane_body}) {
    double const depth = s == ring_body ? length : 1;  // a ring is a length more than a section
    double const volume = length * length * depth, mass = rho * volume;
    double const cells = s == ring_body ? l * l * l : l * l;
    EXPECT_DOUBLE_EQ(to_lattice_volume(units, s, volume), cells);
    EXPECT_DOUBLE_EQ(to_lattice_flow_rate(units, s, volume / time), cells / t);
    EXPECT_DOUBLE_EQ(to_lattice_mass(units, s, mass), r * cells);
    EXPECT_DOUBLE_EQ(to_lattice_force(units, s, mass * a),  // Newton's second law
                     r * cells * to_lattice_acceleration(units, a));
    EXPECT_DOUBLE_EQ(to_lattice_stiffness(units, s, mass * a / length),
                     to_lattice_force(units, s, mass * a) / l);
    EXPECT_DOUBLE_EQ(to_lattice_energy(units, s, mass * a * length),
                     to_lattice_force(units, s, mass * a) * l);
  }
}

}  // namespace
}  // namespace velum::tests
