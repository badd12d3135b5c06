#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace velum::core {

/// One quantity of a time series. The unit is SI, "1" for a plain number.
struct Column {
  std::string name, unit;
};

/// A CSV file that grows by a row per sample; each row is on the disk when append() returns. The
/// header is `name [unit]`; the first column is the time in seconds, or what else orders the rows.
/// The first row belongs to the state before the first step.
struct Series {
  std::filesystem::path path;
  std::ofstream file;
  std::size_t columns;    // without the first
  std::int64_t rows = 0;  // written so far
};

/// Starts the file with its header.
/// @throws InputError  the file cannot be written, or a name cannot stand in a header
Series start_series(std::filesystem::path const& file, std::vector<Column> const& columns,
                    Column const& first = {"time", "s"});

/// Goes on with the file of an earlier run: its header and first rows are kept, later ones dropped.
/// Where it has fewer, or is gone, it goes on with what there is.
/// @throws InputError  it has other columns, or cannot be written
Series resume_series(std::filesystem::path const& file, std::vector<Column> const& columns,
                     std::int64_t rows, Column const& first = {"time", "s"});

/// Adds the row at a time; every number reads back as the same double ("nan" and "inf" as such).
/// @param values  one per column, in their order, SI
/// @throws InputError  the row cannot be written, or has the wrong length
void append(Series& series, double time, std::vector<double> const& values);

}  // namespace velum::core
