#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace velum::cases {

enum class Command { run, check, stl, mesh, chart, sweep, limits, fit, plot, bench, info };

/// What the command line asks for.
struct Options {
  Command command;
  std::filesystem::path scene;
  std::vector<std::filesystem::path> scenes;  // of a chart
  std::vector<std::string> over;              // "key=value,value", of a sweep,
  std::vector<std::string> show;              // and the figures that it shows; empty: its choice
  std::string map;                            // of limits
  int cells = 0;                              // across a map's flow; 0: the command's choice
  bool quick = false;                         // fewer and coarser runs
  std::vector<std::string> set;               // "key=value"
  std::filesystem::path restart;              // checkpoint to go on from; empty: none
  std::filesystem::path out;                  // empty: results/<name of the scene or STL file>
  std::filesystem::path stl, mesh;            // the STL or the mesh file,
  std::string unit, dx, cut;  // its unit, the cells it is looked at with, "x=0.5 mm" or empty
  std::vector<std::filesystem::path> data;  // files of test data,
  std::string model;                        // the law to fit, empty for all,
  double from = 0, to = 20;                 // between these stretches,
  bool relative = false;                    // weighing each point by its own stress
  int threads = 0;                          // 0: all
  std::filesystem::path run;                // folder of results, to plot
  bool json = false;                        // of bench and mesh
  bool quiet = false;
  std::vector<std::string> kokkos;  // --kokkos-* arguments as they are
};

/// Either options, or the exit code of a command line that is already answered: 0 after --help and
/// --version, 2 after a misuse, whose sentence is on stderr.
struct CommandLine {
  std::optional<Options> options;
  int exit_code = 0;
};

CommandLine read_command_line(int argc, char const* const* argv);

}  // namespace velum::cases
