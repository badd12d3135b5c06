#pragma once
#include "core/output/series.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace velum::cases {

/// The rows of a run's series, SI.
struct History {
  std::vector<core::Column> columns;
  std::vector<double> time;
  std::vector<std::vector<double>> rows;  // [time][column]

  bool has(std::string const& name) const
  {
    for (auto const& c : columns)
      if (c.name == name) return true;
    return false;
  }

  /// One column over time.
  /// @pre it exists
  std::vector<double> column(std::string const& name) const
  {
    std::size_t k = 0;
    while (columns[k].name != name) ++k;
    std::vector<double> values;
    values.reserve(rows.size());
    for (auto const& row : rows) values.push_back(row[k]);
    return values;
  }
};

/// The rows of a series.csv that start_series() began.
/// @throws core::InputError  it cannot be read
History read_history(std::filesystem::path const& file);

}  // namespace velum::cases
