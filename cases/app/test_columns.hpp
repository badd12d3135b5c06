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

/// The one column that has one of these names.
/// @param what  it should hold, for the sentence of a file that has none
/// @throws core::InputError  there is none, with the name of a similar one, or there are several
TestColumn const& one_of(TestColumns const& data, std::vector<std::string> const& names,
                         std::string const& what);

/// Values of a column in SI. A dimensionless column without unit takes `otherwise`, if that is not
/// empty.
/// @throws core::InputError  an empty cell, no number, a unit missing, unknown or of another kind
std::vector<double> values(TestColumns const& data, TestColumn const& column,
                           core::Dimension dimension, std::string const& otherwise = "");

}  // namespace velum::cases
