#include "core/output/series.hpp"

#include "core/check.hpp"
#include "core/output/folder.hpp"

#include <fmt/format.h>

namespace velum::core {

namespace {

std::string header_of(std::vector<Column> const& columns, Column const& first)
{
  std::string header = fmt::format("{} [{}]", first.name, first.unit);
  for (auto const& [name, unit] : columns) {
    require((name + unit).find_first_of(",\"\n[]") == std::string::npos,
            fmt::format("\"{} [{}]\" cannot be the header of a column.", name, unit));
    header += fmt::format(",{} [{}]", name, unit);
  }
  return header;
}

}  // namespace

Series start_series(std::filesystem::path const& file, std::vector<Column> const& columns,
                    Column const& first)
{
  std::string const header = header_of(columns, first);
  Series series{file, std::ofstream(file), columns.size()};
  series.file << header << std::endl;
  require(static_cast<bool>(series.file), fmt::format("{} cannot be written.", file.string()));
  return series;
}

Series resume_series(std::filesystem::path const& file, std::vector<Column> const& columns,
                     std::int64_t rows, Column const& first)
{
  std::ifstream old(file);
  std::string line;
  if (!std::getline(old, line)) return start_series(file, columns, first);
  require(line == header_of(columns, first),
          fmt::format("{} has other columns than this run would write; choose another --out.",
                      file.string()));
  std::string kept = line + '\n';
  std::int64_t found = 0;
  // a row cut short by the end of the earlier run has no end of line
  for (; found < rows && std::getline(old, line) && !old.eof(); ++found) kept += line + '\n';
  write_atomically(file, kept);
  Series series{file, std::ofstream(file, std::ios::app), columns.size(), found};
  require(static_cast<bool>(series.file), fmt::format("{} cannot be written.", file.string()));
  return series;
}

void append(Series& series, double time, std::vector<double> const& values)
{
  require(values.size() == series.columns,
          fmt::format("A row of {} has {} values where {} are needed.", series.path.string(),
                      values.size(), series.columns));
  std::string row = fmt::format("{}", time);
  for (double const value : values) row += fmt::format(",{}", value);
  series.file << row << std::endl;
  require(static_cast<bool>(series.file),
          fmt::format("{} cannot be written: is the disk full?", series.path.string()));
  ++series.rows;
}

}  // namespace velum::core
