// problem:    the valve's membrane on its seat at 20, 50, 100, 200 and 300 kPa, hydrostatic
// pressure reference:  itself with half the element size, and ten times the contact stiffness
// measure:    centre deflection; penetration; growth with the pressure
// tolerance:  0.2 % of the deflection; penetration below 1.5 um at 300 kPa
// why:        second-order elements of 0.1 mm: 0.05 % seen; penetration is p_contact / k, and the
//             lip's line load over 0.1 mm is about four times the 300 kPa
#include "structure/internal_force.hpp"
#include "tests/contact/pressed_membrane.hpp"
#include "tests/contact/valve_membrane.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace velum::tests {
namespace {

TEST(ClosedValve, deflects_as_computed)
{
  auto s = closed_valve(1e12, false), fine = closed_valve(1e12, false, 5e-5),
       hard = closed_valve(1e13, false);
  double previous = 0;
  for (double const p : {20e3, 50e3, 100e3, 200e3, 300e3}) {
    auto const r = press(s, p, contact::LipPressure::linear, false);
    press(fine, p, contact::LipPressure::linear, false);
    press(hard, p, contact::LipPressure::linear, false);
    double const w0 = s.membrane.position[0];
    EXPECT_NEAR(fine.membrane.position[0], w0, 0.002 * std::abs(w0)) << p;
    EXPECT_NEAR(hard.membrane.position[0], w0, 0.002 * std::abs(w0)) << p;
    EXPECT_LT(w0, previous - 0.1e-3) << p;
    EXPECT_TRUE(touches(r.patch)) << p;
    EXPECT_LT(r.patch.penetration, 1.5e-6) << p;
    EXPECT_LT(structure::largest_stretch(s.membrane, s.membrane.position), 1.2) << p;
    previous = w0;
  }
}

}  // namespace
}  // namespace velum::tests
