#include "cases/app/test_columns.hpp"

#include "cases/app/csv_text.hpp"
#include "cases/app/scene_text.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace velum::cases {
namespace {

std::map<std::string, std::string> read_remarks(std::filesystem::path const& path)
{
  std::ifstream file(path);
  std::map<std::string, std::string> remarks;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // byte order mark
    auto const start = line.find('#');
    auto const equals = line.find('=');
    if (start == std::string::npos || trimmed(line.substr(0, start)) != "" ||
        equals == std::string::npos)
      continue;
    remarks[trimmed(line.substr(start + 1, equals - start - 1))] = trimmed(line.substr(equals + 1));
  }
  return remarks;
}

TestColumn take_apart(std::string const& head)
{
  auto const open = head.find('['), close = head.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open)
    return {head, head, ""};
  return {head, trimmed(head.substr(0, open)), trimmed(head.substr(open + 1, close - open - 1))};
}

/// "file:line" of the header.
std::string header_place(TestColumns const& data)
{
  return fmt::format("{}:{}", data.table.path.string(), data.table.header_line);
}

/// The column of that name, or nullptr.
TestColumn const* find_column(TestColumns const& data, std::string const& name)
{
  TestColumn const* found = nullptr;
  for (auto const& column : data.columns) {
    if (column.name != name) continue;
    core::require(!found, fmt::format("{}: has two columns \"{}\".", header_place(data), name));
    found = &column;
  }
  return found;
}

/// "; did you mean "x"?" with the first column that is nearly one of these, or ".".
std::string similar_column(TestColumns const& data, std::vector<std::string> const& names)
{
  for (auto const& column : data.columns)
    if (auto hint = did_you_mean(column.name, names); !hint.empty()) return hint;
  return ".";
}

}  // namespace

TestColumns read_test_columns(std::filesystem::path const& path)
{
  std::error_code ignored;
  core::require(std::filesystem::is_regular_file(path, ignored),
                fmt::format("{}: there is no such file of test data.", path.string()));
  TestColumns data{read_table_file(path, {}), {}, read_remarks(path)};
  for (auto const& head : data.table.columns) data.columns.push_back(take_apart(head));
  core::require(data.columns.size() > 1 || data.columns.front().head.find(';') == std::string::npos,
                fmt::format("{}: separates its columns by semicolons; write commas, and points as "
                            "decimal signs.",
                            header_place(data)));
  return data;
}

TestColumn const& one_of(TestColumns const& data, std::vector<std::string> const& names,
                         std::string const& what)
{
  TestColumn const* found = nullptr;
  for (auto const& each : names)
    if (auto const* column = find_column(data, each)) {
      core::require(!found,
                    fmt::format("{}: has both a column \"{}\" and a column \"{}\"; which "
                                "one is meant?",
                                header_place(data), found ? found->head : "", column->head));
      found = column;
    }
  core::require(found != nullptr, fmt::format("{}: has no column of {}{}", header_place(data), what,
                                              similar_column(data, names)));
  return *found;
}

std::vector<double> values(TestColumns const& data, TestColumn const& column,
                           core::Dimension dimension, std::string const& otherwise)
{
  std::string unit = column.unit.empty() ? otherwise : column.unit;
  std::string const usual = dimension == core::Dimension::dimensionless
                                ? "[1] or [%]"
                                : fmt::format("[{}]", core::usual_units(dimension).front());
  core::require(!unit.empty(), fmt::format("{}: column \"{}\" has no unit; write \"{} {}\".",
                                           header_place(data), column.head, column.name, usual));
  double factor = 1;
  if (unit != "1" || dimension != core::Dimension::dimensionless) try {
      factor = core::parse_quantity("1 " + unit, dimension);
    } catch (core::InputError const& error) {
      throw core::InputError(
          fmt::format("{}: column \"{}\": {}", header_place(data), column.head, error.what()));
    }
  std::vector<double> all;
  for (std::size_t row = 0; row < data.table.rows.size(); ++row) {
    auto const value = number(data.table, row, column.head);
    core::require(value.has_value(),
                  fmt::format("{}:{}: has no value in column \"{}\".", data.table.path.string(),
                              data.table.lines[row], column.head));
    all.push_back(factor * *value);
  }
  return all;
}

}  // namespace velum::cases
