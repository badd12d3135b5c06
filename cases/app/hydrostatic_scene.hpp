#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"
#include "ibm/hydrostatic.hpp"
#include "structure/lift_stop.hpp"
#include "structure/stepper.hpp"

namespace velum::cases {

/// Membrane, spring and seat of a scene in static equilibrium with fluid at rest. Lattice units.
struct HydrostaticScene {
  structure::Membrane membrane;
  std::vector<structure::Load> bending;       // empty: none
  std::vector<structure::Load> loads;         // bending and spring
  std::vector<int> driven;                    // nodes of the centre that is moved as given
  std::shared_ptr<ibm::SeatContact> seat;     // empty without a contact
  std::optional<structure::LiftStop> stop{};  // its load is added once the valve is closed
  int substeps = 1;                           // of an explicit step of the lattice's length
  ibm::HydrostaticLoad load;                  // the region pressures
  ibm::HydrostaticReport report;
  Eigen::VectorXd contact_stiffness;  // per node
};

/// Membrane, spring and contact, undeformed. The penalty is the scene's, or as stiff as sub-steps
/// of the lattice's step stay stable with.
HydrostaticScene make_membrane_scene(Scene const& scene, Derived const& derived);

/// Closes the membrane by its spring at zero pressure, then applies the pressures at time 0: the
/// chamber's or the inlet's above, the inlet's outside the seat, the outlet's inside.
/// Throws core::InputError where the membrane does not reach its seat: then no region is sealed and
/// fluid at rest has no answer.
void find_equilibrium(HydrostaticScene& s, Scene const& scene, Derived const& derived);

/// Rayleigh damping of the membrane's material, lattice units.
structure::Rayleigh membrane_damping(Scene const& scene, Derived const& derived);

/// Its stepper by the scheme that was chosen, with the damping of the stiffness of where it is;
/// lattice units.
structure::Stepper membrane_stepper(Scene const& scene, Derived const& derived,
                                    HydrostaticScene const& start);

/// Pressure of the inlet and of the outlet at a time, Pa; 0 where the scene has none.
double inlet_pressure(Scene const& scene, double time);
double outlet_pressure(Scene const& scene, double time);

/// Pressure above the membrane at the start, Pa: its chamber's, or the inlet's.
double pressure_above(Scene const& scene);

/// The hydrostatic fidelity: equilibrium alone, written as a result.
void run_hydrostatic(Scene const& scene, std::filesystem::path const& out);

}  // namespace velum::cases
