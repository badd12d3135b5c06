#pragma once
#include <memory>
#include <vector>

#include "contact/lip_pressure.hpp"
#include "ibm/contact_load.hpp"
#include "structure/pressure_load.hpp"
#include "structure/static_solve.hpp"

namespace velum::ibm {

/// A membrane on a seat in fluid at rest: the pressure is constant in each connected region. The
/// seat's contact patch parts the minus side in two.
struct HydrostaticLoad {
  double above = 0;    // on the plus face
  double inside = 0;   // on the minus face, y below the patch
  double outside = 0;  // on the minus face, y beyond the patch
  contact::LipPressure lip = contact::LipPressure::linear;
};

struct HydrostaticReport {
  contact::Patch patch;
  structure::FacePressure pressure;  // of the last solve
  int iterations = 0;                // linear solves of all Newton solves
  int updates = 0;                   // of contact patch, thickness and multipliers
};

/// Pressure on both faces for a contact patch whose ends lie anywhere along the elements; marker a
/// of the patch is node a.
structure::FacePressure pressure_by_region(structure::Membrane const& membrane,
                                           contact::Patch const& patch,
                                           HydrostaticLoad const& load);

/// Moves the membrane to static equilibrium under the region pressures, the contact and the further
/// loads. Solved again until patch, thickness and, with augment, the multipliers stand still.
/// Throws core::Divergence where there is no equilibrium.
HydrostaticReport hydrostatic_equilibrium(structure::Membrane& membrane,
                                          std::shared_ptr<SeatContact> const& seat,
                                          std::vector<structure::Load> loads,
                                          HydrostaticLoad const& load, bool augment);

}  // namespace velum::ibm
