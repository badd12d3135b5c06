#pragma once
#include "cases/app/scene.hpp"
#include "core/grid.hpp"
#include "core/units.hpp"
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/scheme.hpp"

#include <cstdint>

namespace velum::cases {

/// Numbers that follow from a scene; `run` computes with them and `check` shows them. SI units
/// unless said otherwise; what concerns the membrane is 0 without one.
struct Derived {
  core::Units units;        // dx, dt, rho
  core::Grid grid;          // lengths in metres
  double velocity;          // reference velocity
  double pressure;          // largest pressure of a boundary
  double mach;              // reference velocity over sound_speed
  double sound_speed;       // of the lattice, dx / (dt sqrt 3)
  double viscosity;         // lattice units
  double tau_minus_half;    // relaxation time less 1/2, lattice units: 3 viscosity
  double cell_reynolds;     // velocity dx / nu
  double density_jump;      // relative, pressure / (rho c_s^2)
  double acoustic_transit;  // longer side of the domain / sound_speed
  std::int64_t steps;       // of the whole run
  double thickness;         // least of the membrane
  double mass_ratio;        // rho_s thickness / (rho dx)
  double structure_step;    // stable step of the undamped explicit membrane, without contact
  int sub_steps;            // of the membrane in one step of the fluid, were they explicit
  /// How the membrane takes a step of the fluid, contact included.
  structure::SchemeChoice membrane_scheme;
  double damping_step;  // what an explicit beta K0 would allow: 2 / (beta omega^2)
};

/// Largest velocity that the boundaries, a body force, the initial flow and a prescribed motion can
/// cause: sqrt(2 p / rho) of the largest pressure, the top of a given velocity profile, flow rate /
/// area, laminar flow under the body force, or slope of the motion. 0 if none.
double reference_velocity(Scene const& scene);

/// The velocity with which a flow is made dimensionless: largest of the initial one and of the mean
/// velocities that boundaries impose at the end. 0 if none.
double flow_velocity(Scene const& scene);

/// Area of a boundary's patches, m2; one on a solid counts as if it faced the first axis.
/// @pre the boundary exists
double opening_area(Scene const& scene, std::string const& boundary);

/// The step is dt = u_lat dx / u_ref with u_lat = mach / sqrt 3, or as given; a hydrostatic scene
/// where nothing drives takes the velocity of 1 kPa.
Derived derive(Scene const& scene);

/// Says what keeps a scene from being marched: a time step that its end does not hold once, or with
/// which the reference velocity is no slower than sound.
/// @throws core::InputError
void check_time_step(Scene const& scene, Derived const& d);

/// A membrane as the structure sees it: flat, at rest, metres.
structure::Membrane make_membrane(MembraneSheet const& sheet, Material const& material,
                                  core::Symmetry symmetry);

/// That of the scene.
/// @pre the scene has a membrane
structure::Membrane make_membrane(Scene const& scene);

/// Its bending as a load, in the membrane's own units; none where it does not bend.
std::vector<structure::Load> bending_of(MembraneSheet const& sheet,
                                        structure::Membrane const& membrane);

}  // namespace velum::cases
