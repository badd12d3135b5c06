#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace velum::core {

/// What a number measures. Several share their SI unit (a flow rate per depth and a kinematic
/// viscosity): they differ in the words of the messages.
enum class Dimension {
  dimensionless,
  length,
  area,
  volume,
  time,
  frequency,
  velocity,
  acceleration,
  angle,
  mass,
  density,
  force,
  stiffness,            // N/m; also a force per depth and a membrane tension
  stiffness_per_depth,  // N/m2: a spring on a planar body of unit depth
  pressure,             // also an elastic modulus
  kinematic_viscosity,
  dynamic_viscosity,
  flow_rate,
  flow_rate_per_depth,
};

/// Name for messages, with its article: "a pressure".
std::string_view name(Dimension dimension);
/// SI unit as written in outputs: "Pa"; "1" for a plain number.
std::string_view si_unit(Dimension dimension);
/// Units to suggest, the most usual first. Any product of known units of the right dimension is
/// accepted besides.
std::vector<std::string> usual_units(Dimension dimension);

/// SI value of a number with unit, "100 kPa" -> 1e5; blanks do not matter. A plain number takes no
/// unit (or "%"), everything else must have one.
/// @throws InputError  not a number, not finite, unit missing, unknown (with the nearest spelling)
///                     or of another dimension
double parse_quantity(std::string_view text, Dimension expected);

}  // namespace velum::core
