#include "core/output/summary.hpp"

#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "core/output/json.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

namespace velum::core {

std::string to_json(Summary const& summary)
{
  std::set<std::string> names{"assumptions"};
  std::string out = "{\n";
  for (auto const& [name, value, unit] : summary.figures) {
    require(names.insert(name).second, "The summary has two entries named " + name + ".");
    out += fmt::format("  {}: {{\"value\": {}, \"unit\": {}}},\n", json_string(name),
                       json_number(value), json_string(unit));
  }
  out += "  \"assumptions\": {";
  std::string_view separator = "\n";
  for (auto const& [name, text] : summary.assumptions) {
    out += fmt::format("{}    {}: {}", separator, json_string(name), json_string(text));
    separator = ",\n";
  }
  return out + (summary.assumptions.empty() ? "}\n}\n" : "\n  }\n}\n");
}

void write_summary(std::filesystem::path const& file, Summary const& summary)
{
  write_atomically(file, to_json(summary));
}

}  // namespace velum::core
