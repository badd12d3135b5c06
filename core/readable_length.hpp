#pragma once
#include <string>

namespace velum::core {

/// A unit of length with a prefix.
struct LengthUnit {
  double metres;
  char const* name;
};

/// The unit in which a length has one to three digits before the point: nm, um, mm or m.
LengthUnit readable_unit(double metres);

/// "250 um", with four digits.
std::string readable_length(double metres);

/// "(1, 2.5, 0) mm", in the unit of the largest; what is round-off beside it is 0.
std::string readable_place(double x, double y, double z);

}  // namespace velum::core
