#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "cases/app/commands.hpp"
#include "cases/app/plot_script.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"

namespace velum::cases {
namespace {

/// Whether a series has two rows, the least that makes a line.
bool has_two_rows(std::filesystem::path const& series)
{
  std::ifstream file(series);
  std::string line;
  int lines = 0;
  while (lines < 3 && std::getline(file, line)) ++lines;
  return lines == 3;
}

}  // namespace

void plot_command(Options const& options)
{
  std::string const folder = options.run.string();
  core::require(std::filesystem::is_directory(options.run),
                fmt::format("{}: there is no such folder of results.", folder));
  auto const series = options.run / "series.csv";
  core::require(std::filesystem::exists(series),
                fmt::format("{}: there is no series.csv of a run in this folder.", folder));
  core::require(has_two_rows(series),
                fmt::format("{}: a picture takes two rows, and the run has not got so far.",
                            series.string()));
  std::string const python = setting("PYTHON", "/usr/bin/python3");
  core::require(succeeds({python, "-c", "import matplotlib, numpy, h5py"}, Voice::silent),
                fmt::format("velum plot takes a Python with matplotlib, numpy and h5py, and {} is "
                            "none; PYTHON may name another.",
                            python));
  auto const out = core::make_folder(options.out.empty() ? options.run : options.out);
  auto const script = plot_script("plot_run.py").string();
  std::fflush(stdout);
  core::require(
      succeeds({python, script, std::filesystem::absolute(options.run).string(), out.string()},
               options.quiet ? Voice::silent : Voice::heard),
      fmt::format("The pictures of {} were not drawn; {} {} {} {} says why.", folder, python,
                  script, folder, out.string()));
}

}  // namespace velum::cases
