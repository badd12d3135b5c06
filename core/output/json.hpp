#pragma once
#include <string>
#include <string_view>

namespace velum::core {

/// A text as JSON, in quotes.
std::string json_string(std::string_view text);

/// The shortest text that reads back as the same double; null where it is not finite.
std::string json_number(double value);

}  // namespace velum::core
