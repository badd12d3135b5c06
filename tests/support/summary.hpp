#pragma once
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

namespace velum::tests {

/// A figure of a run's summary.json.
inline double figure(std::filesystem::path const& folder, std::string const& name)
{
  std::ifstream const file(folder / "summary.json");
  std::ostringstream text;
  text << file.rdbuf();
  std::string const all = text.str();
  std::smatch match;
  if (!std::regex_search(all, match,
                         std::regex("\"" + name + "\":\\s*\\{\\s*\"value\":\\s*([^,]+),")))
    throw std::runtime_error("summary.json has no figure " + name);
  return std::stod(match[1]);
}

}  // namespace velum::tests
