#include "cases/app/length_option.hpp"

#include "core/quantity.hpp"

#include <fmt/format.h>

namespace velum::cases {

double positive_length(char const* option, std::string const& text)
{
  double const metres =
      parse_option(option, [&] { return core::parse_quantity(text, core::Dimension::length); });
  core::require(metres > 0, fmt::format("{}: \"{}\" is not a positive length.", option, text));
  return metres;
}

double file_unit(std::string const& text)
{
  bool const counted = text.find_first_of("0123456789") != std::string::npos;
  return positive_length("--unit", counted ? text : "1 " + text);
}

}  // namespace velum::cases
