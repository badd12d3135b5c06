#include "cases/app/table_file.hpp"

#include "cases/app/csv_text.hpp"
#include "core/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace velum::cases {
namespace {

std::vector<std::string> cells(std::string const& line)
{
  std::vector<std::string> all;
  std::istringstream rest(line + ',');
  for (std::string cell; std::getline(rest, cell, ',');) all.push_back(trimmed(cell));
  return all;
}

}  // namespace

TableFile read_table_file(std::filesystem::path const& path,
                          std::vector<std::string> const& required)
{
  std::ifstream file(path);
  core::require(file.good(), fmt::format("{}: cannot be read.", path.string()));
  TableFile table{path, {}, {}, {}, 0};
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    auto row = cells(line);
    if (table.columns.empty()) {
      table.columns = std::move(row);
      table.header_line = number;
      continue;
    }
    core::require(row.size() == table.columns.size(),
                  fmt::format("{}:{}: has {} values, but the header names {} columns.",
                              path.string(), number, row.size(), table.columns.size()));
    table.rows.push_back(std::move(row));
    table.lines.push_back(number);
  }
  for (auto const& column : required)
    core::require(
        std::find(table.columns.begin(), table.columns.end(), column) != table.columns.end(),
        fmt::format("{}: has no column \"{}\"; a reference of this kind needs the columns {}.",
                    path.string(), column, fmt::join(required, ", ")));
  core::require(!table.rows.empty(), fmt::format("{}: has no rows.", path.string()));
  return table;
}

std::string text(TableFile const& table, std::size_t row, std::string const& column)
{
  auto const at = std::find(table.columns.begin(), table.columns.end(), column);
  if (at == table.columns.end()) return {};
  return table.rows[row][static_cast<std::size_t>(at - table.columns.begin())];
}

std::optional<double> number(TableFile const& table, std::size_t row, std::string const& column)
{
  std::string const cell = text(table, row, column);
  if (cell.empty()) return {};
  std::size_t used = 0;
  double value = std::nan("");
  try {
    value = std::stod(cell, &used);
  } catch (std::exception const&) {
    used = 0;
  }
  core::require(used == cell.size() && std::isfinite(value),
                fmt::format("{}:{}: \"{}\" in column \"{}\" is not a number.", table.path.string(),
                            table.lines[row], cell, column));
  return value;
}

}  // namespace velum::cases
