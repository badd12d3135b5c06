#pragma once
#include "cases/app/table_file.hpp"
#include "core/quantity.hpp"

#include <map>
#include <string>
#include <vector>

namespace velum::cases {

/// A column of a table, its head "name [unit]" taken apart.
struct TestColumn {
  std::string head, name, unit;
};

/// The columns of a file of test data.
struct TestColumns {
  TableFile table;
  std::vector<TestColumn> columns;
  std::map<std::string, std::string> remarks;  // "# key = value" above the header
};

/// @throws core::InputError  no such file, no rows, rows of different lengths, no commas
TestColumns read_test_columns(std::filesystem::path const& path);

/// The column of that name, or nullptr.
/// @throws core::InputError  there are two
TestColumn const* find_column(TestColumns const& data, std::string const& name);

/// Values of a column in SI. A dimensionless column without unit takes `otherwise`, if that is not
/// empty.
/// @throws core::InputError  an empty cell, no number, a unit that is missing, unknown or of
/// another
///     dimension
std::vector<double> values(TestColumns const& data, TestColumn const& column,
                           core::Dimension dimension, std::string const& otherwise = "");

/// "file:line" of the header.
std::string header_place(TestColumns const& data);

/// "; did you mean "x"?" with the first column that is nearly one of these; empty where none is.
std::string similar_column(TestColumns const& data, std::vector<std::string> const& names);

}  // namespace velum::cases
