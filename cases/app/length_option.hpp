#pragma once
#include "core/check.hpp"

#include <string>

namespace velum::cases {

/// What parse() gives; the sentence of a bad value, with the option in front that it was given to.
template <class Parse>
auto parse_option(char const* option, Parse const& parse)
{
  try {
    return parse();
  } catch (core::InputError const& error) {
    throw core::InputError(option + std::string(": ") + error.what());
  }
}

/// Metres of "0.1 mm". @throws InputError  no length, or none above 0
double positive_length(char const* option, std::string const& text);

/// Metres in one unit of a file, given to --unit as "mm" or "25.4 mm".
double file_unit(std::string const& text);

}  // namespace velum::cases
