#include "core/output/json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace velum::core {

std::string json_string(std::string_view text)
{
  std::string out = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string json_number(double value)
{
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

}  // namespace velum::core
