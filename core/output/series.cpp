#include "core/output/series.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

namespace velum::core {

Series start_series(std::filesystem::path const& file, std::vector<Column> const& columns,
                    Column const& first)
{
  std::string header = fmt::format("{} [{}]", first.name, first.unit);
  for (auto const& [name, unit] : columns) {
    require((name + unit).find_first_of(",\"\n[]") == std::string::npos,
            fmt::format("\"{} [{}]\" cannot be the header of a column.", name, unit));
    header += fmt::format(",{} [{}]", name, unit);
  }
  Series series{file, std::ofstream(file), columns.size()};
  series.file << header << std::endl;
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
}

}  // namespace velum::core
