#pragma once
#include <memory>
#include <vector>

#include "contact/lip_pressure.hpp"
#include "ibm/network.hpp"
#include "ibm/seat_gap.hpp"
#include "structure/stepper.hpp"

namespace velum::ibm {

/// A membrane on its seat between lumped volumes of liquid, no lattice: above the plus face one
/// chamber, below the minus face one beyond the seat and one within, joined by the gap. Consistent
/// units, those of the lattice in a scene.
struct Lumped {
  structure::Membrane membrane;
  structure::Stepper stepper;
  std::vector<structure::Load> loads;  // bending, spring, contact
  std::shared_ptr<SeatContact> seat;
  contact::LipPressure lip = contact::LipPressure::linear;
  GapLaw law;
  Network network;
  int above, outside, inside;  // chambers
  int gap_passage;             // from outside to inside
  int substeps = 1;            // of the explicit stepper

  SeatGap gap;  // of the last step
};

/// Gap and its loss in the present state.
void locate(Lumped& s);

/// One step of length h: membrane, contact, chamber pressures and flows, found together
/// (structure/enclosure.hpp); the gap's shape lags by one step.
void step(Lumped& s, double h);

}  // namespace velum::ibm
