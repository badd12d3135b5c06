#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace velum::core {

/// Powers of metre, kilogram, second and radian. The radian is kept so that an angle is not taken
/// for a plain number.
using Exponents = std::array<int, 4>;

/// A unit of measurement: its value in SI units is numerator / denominator, two numbers that are
/// exact wherever the unit is defined by one, so that "40 um" becomes the double nearest to 4e-5.
struct Unit {
  double numerator = 1, denominator = 1;
  Exponents exponents{};
};

/// Reads a product of units with SI prefixes and integer powers: "kPa", "N/mm", "kg/m3", "m^2/s",
/// "Pa s", "1/s". What follows a slash divides, up to the next space, '*' or slash.
/// @return the unit, or nothing when a factor is unknown; its text is then left in `unknown`
std::optional<Unit> parse_unit(std::string_view text, std::string& unknown);

}  // namespace velum::core
