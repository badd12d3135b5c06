// problem:    pressure on a face that lies on a seat from s = 2 to s = 4, 7 before and 1 after
// reference:  none: dry land; linear: 7 to 1 in a straight line
// measure:    values before, within, at the edges, after
// tolerance:  exact
// why:        site function of a few operations
#include "contact/lip_pressure.hpp"

#include <gtest/gtest.h>

namespace velum::contact {
namespace {

TEST(LipPressure, falls_linearly_or_is_absent)
{
  for (auto const lip : {LipPressure::none, LipPressure::linear}) {
    EXPECT_EQ(face_pressure(lip, 1.9, 2, 4, 7, 1), 7);
    EXPECT_EQ(face_pressure(lip, 4.1, 2, 4, 7, 1), 1);
  }
  EXPECT_EQ(face_pressure(LipPressure::none, 3, 2, 4, 7, 1), 0);
  EXPECT_EQ(face_pressure(LipPressure::linear, 2, 2, 4, 7, 1), 7);
  EXPECT_EQ(face_pressure(LipPressure::linear, 3, 2, 4, 7, 1), 4);
  EXPECT_EQ(face_pressure(LipPressure::linear, 4, 2, 4, 7, 1), 1);
  EXPECT_EQ(face_pressure(LipPressure::linear, 2, 2, 2, 7, 1), 4);  // a line of contact
}

}  // namespace
}  // namespace velum::contact
