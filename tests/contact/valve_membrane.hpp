#pragma once
#include "structure/spring.hpp"
#include "tests/contact/pressed_membrane.hpp"

namespace velum::tests {

/// The paper's spring with 0.913 N of preload, on the middle 3 mm.
inline structure::Spring const spring_of_the_valve{100, 14e-3, 4.868e-3, 3e-3};

/// The main membrane of the valve, 2 mm thick, pulled onto its seat (land 5.0 to 5.5 mm, its top
/// 0.1 mm below the flat membrane's face) by the spring alone; SI units.
/// @param shift  moves membrane and seat together along the axis
inline PressedMembrane closed_valve(double stiffness, bool augment, double element_size = 1e-4,
                                    double shift = 0)
{
  auto membrane = structure::flat_membrane({core::Symmetry::axisymmetric, 0, 8.25e-3, element_size,
                                            [](double) { return 2e-3; },
                                            structure::neo_hookean_rubber(0.946e6), 1140, shift});
  double const top = shift - 1.1e-3, foot = shift - 3e-3;
  auto seat = core::polygon({{foot, 5e-3}, {top, 5e-3}, {top, 5.5e-3}, {foot, 5.5e-3}}, 0.15e-3);
  auto s = pressed(std::move(membrane), std::move(seat), stiffness);
  settle(s, {structure::spring_load(s.membrane, spring_of_the_valve)}, contact::LipPressure::none,
         0, 0, 0, augment);
  return s;
}

/// Puts p on the plus face and on the minus face outside the seat, zero inside.
inline PressedReport press(PressedMembrane& s, double p, contact::LipPressure lip, bool augment)
{
  return settle(s, {structure::spring_load(s.membrane, spring_of_the_valve)}, lip, p, 0, p,
                augment);
}

}  // namespace velum::tests
