#pragma once
#include <string>

namespace velum::cases {

/// A cell of a CSV file: quoted where it holds a comma, a quotation mark or a line break (RFC
/// 4180).
inline std::string csv_cell(std::string const& text)
{
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (char const c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

/// A cell as it was read, without the blanks around it.
inline std::string trimmed(std::string const& text)
{
  auto const first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace velum::cases
