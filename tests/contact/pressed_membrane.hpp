#pragma once
#include "contact/augmented_lagrangian.hpp"
#include "contact/lip_pressure.hpp"
#include "contact/patch.hpp"
#include "ibm/hydrostatic.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace velum::tests {

/// A membrane and the seat under its minus side.
struct PressedMembrane {
  structure::Membrane membrane;
  std::shared_ptr<ibm::SeatContact> seat;
};

inline PressedMembrane pressed(structure::Membrane membrane, core::Obstacle const& seat,
                               double stiffness)
{
  auto contact =
      std::make_shared<ibm::SeatContact>(ibm::make_seat_contact(seat, stiffness, membrane));
  ibm::press(*contact, membrane.position);
  return {std::move(membrane), std::move(contact)};
}

using PressedReport = ibm::HydrostaticReport;

/// Static equilibrium under the given further loads and pressures: augmented Lagrangian when
/// `augment`, plain penalty else.
inline PressedReport settle(PressedMembrane& s, std::vector<structure::Load> const& loads,
                            contact::LipPressure lip, double above, double inside, double outside,
                            bool augment)
{
  return ibm::hydrostatic_equilibrium(s.membrane, s.seat, loads, {above, inside, outside, lip},
                                      augment);
}

}  // namespace velum::tests
