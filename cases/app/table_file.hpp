#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace velum::cases {

/// A table of reference data: comma-separated values under a header of names. Lines that start with
/// # (the sources) and empty lines are skipped.
struct TableFile {
  std::filesystem::path path;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> lines;  // of the rows in the file
  int header_line;
};

/// @param required  columns that must be there
/// @throws core::InputError  the file cannot be read, a column is missing, a row is too long or
///                           too short
TableFile read_table_file(std::filesystem::path const& path,
                          std::vector<std::string> const& required);

/// Text of a cell; empty where the table has no such column.
std::string text(TableFile const& table, std::size_t row, std::string const& column);

/// Number of a cell; nothing where it is empty or there is no such column.
/// @throws core::InputError  the cell holds something else
std::optional<double> number(TableFile const& table, std::size_t row, std::string const& column);

}  // namespace velum::cases
