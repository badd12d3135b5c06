#include "core/quantity.hpp"

#include "core/check.hpp"
#include "core/spelling.hpp"
#include "core/unit.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstddef>

namespace velum::core {
namespace {

struct Entry {
  Dimension dimension;
  std::string_view name, si_unit;
  std::vector<std::string> usual_units;
};

/// One row per Dimension, in its order.
std::vector<Entry> const& entries()
{
  using enum Dimension;
  static std::vector<Entry> const table = {
      {dimensionless, "a plain number", "1", {"%"}},
      {length, "a length", "m", {"mm", "um", "cm", "m", "nm"}},
      {area, "an area", "m2", {"mm2", "cm2", "m2", "um2"}},
      {volume, "a volume", "m3", {"ml", "l", "mm3", "cm3", "m3", "ul"}},
      {time, "a time", "s", {"ms", "s", "us", "min", "h", "ns"}},
      {frequency, "a frequency", "1/s", {"1/s", "Hz", "kHz", "1/ms"}},
      {velocity, "a velocity", "m/s", {"m/s", "mm/s", "cm/s", "um/s", "mm/ms"}},
      {acceleration, "an acceleration", "m/s2", {"m/s2", "mm/s2"}},
      {angle, "an angle", "rad", {"deg", "rad"}},
      {mass, "a mass", "kg", {"g", "kg", "mg"}},
      {density, "a density", "kg/m3", {"kg/m3", "g/cm3", "kg/l"}},
      {force, "a force", "N", {"N", "mN", "kN", "uN"}},
      {stiffness, "a stiffness or force per length", "N/m", {"N/mm", "N/m", "kN/m", "mN/mm"}},
      {stiffness_per_depth, "a stiffness per depth", "N/m2", {"N/mm2", "N/m2"}},
      {pressure, "a pressure", "Pa", {"kPa", "Pa", "MPa", "bar", "mbar", "hPa", "mmHg", "psi"}},
      {kinematic_viscosity, "a kinematic viscosity", "m2/s", {"m2/s", "mm2/s", "cSt"}},
      {dynamic_viscosity, "a dynamic viscosity", "Pa s", {"mPa s", "Pa s"}},
      {flow_rate, "a flow rate", "m3/s", {"l/h", "l/min", "l/s", "ml/min", "ml/s", "m3/h", "m3/s"}},
      {flow_rate_per_depth, "a flow rate per depth", "m2/s", {"m2/s", "mm2/s"}},
  };
  return table;
}

Entry const& entry(Dimension dimension) { return entries()[static_cast<std::size_t>(dimension)]; }

Unit unit_of(Dimension dimension)
{
  std::string unknown;
  return *parse_unit(entry(dimension).si_unit, unknown);
}

std::string_view trim(std::string_view text)
{
  constexpr std::string_view blank = " \t\r\n";
  std::size_t const first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// What to write instead: "write it in kPa, Pa or MPa, for example "100 kPa"".
std::string advice(Dimension expected, std::string_view number)
{
  auto const units = usual_units(expected);
  if (expected == Dimension::dimensionless) return "write the number alone or with %";
  return fmt::format("write it in {}, for example \"{} {}\"", any_of(units), number, units.front());
}

/// What a unit measures, by the first dimension that it fits.
std::string meaning(Unit const& unit)
{
  for (auto const& candidate : entries())
    if (unit_of(candidate.dimension).exponents == unit.exponents)
      return std::string(candidate.name);
  return "none of the known quantities";
}

std::string suggestion(std::string_view unit, Dimension expected)
{
  std::string const similar = nearest(unit, usual_units(expected));
  return similar.empty() ? "" : fmt::format(" Did you mean \"{}\"?", similar);
}

}  // namespace

std::string_view name(Dimension dimension) { return entry(dimension).name; }

std::string_view si_unit(Dimension dimension) { return entry(dimension).si_unit; }

std::vector<std::string> usual_units(Dimension dimension) { return entry(dimension).usual_units; }

double parse_quantity(std::string_view text, Dimension expected)
{
  std::string_view rest = trim(text);
  std::string_view const shown = rest;
  if (rest.starts_with('+')) rest.remove_prefix(1);

  double value = 0;
  auto const [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  std::string_view const number = rest.substr(0, static_cast<std::size_t>(end - rest.data()));
  require(error != std::errc::invalid_argument,
          fmt::format("\"{}\" is not {}: {}.", shown, name(expected), advice(expected, "1.5")));
  require(error == std::errc{} && std::isfinite(value),
          fmt::format("\"{}\" is not a finite number.", shown));
  std::string_view const unit_text = trim(rest.substr(number.size()));
  require(!unit_text.starts_with(','),
          fmt::format("\"{}\" is not a number: the decimal sign is a point.", shown));

  if (unit_text.empty()) {
    require(expected == Dimension::dimensionless,
            fmt::format("\"{}\" has no unit, and {} needs one: {}.", shown, name(expected),
                        advice(expected, number)));
    return value;
  }

  std::string unknown;
  auto const unit = parse_unit(unit_text, unknown);
  require(unit.has_value(),
          fmt::format("\"{}\" has the unknown unit \"{}\" where {} is expected: {}.{}", shown,
                      unit_text, name(expected), advice(expected, number),
                      suggestion(unit_text, expected)));
  require(unit->exponents == unit_of(expected).exponents,
          fmt::format("\"{}\" is {}, and {} is expected: {}.", shown, meaning(*unit),
                      name(expected), advice(expected, number)));
  double const si = value * unit->numerator / unit->denominator;
  require(std::isfinite(si), fmt::format("\"{}\" is not a finite number.", shown));
  return si;
}

}  // namespace velum::core
