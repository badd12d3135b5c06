#include "cases/app/commands.hpp"
#include "cases/app/version.hpp"

#include <fmt/format.h>
#include <Kokkos_Core.hpp>

#include <cstdlib>
#include <sstream>
#include <string>

namespace velum::cases {
namespace {

std::string variable(char const* name)
{
  char const* value = std::getenv(name);
  return value ? value : "not set";
}

/// Kokkos' own words on the device, indented.
std::string device_description()
{
  std::ostringstream text;
  Kokkos::DefaultExecutionSpace().print_configuration(text);
  std::istringstream lines(text.str());
  std::string all;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) all += "    " + line + '\n';
  return all;
}

}  // namespace

void info_command()
{
  fmt::print("velum {}\n  {}\n", version(), build_description());
  fmt::print("back ends\n  device  {}\n{}  host    {}\n", Kokkos::DefaultExecutionSpace::name(),
             device_description(), Kokkos::DefaultHostExecutionSpace::name());
  fmt::print("threads\n  {}, OMP_PROC_BIND {}, OMP_PLACES {}\n",
             Kokkos::DefaultHostExecutionSpace().concurrency(), variable("OMP_PROC_BIND"),
             variable("OMP_PLACES"));
  fmt::print("libraries\n");
  for (auto const& library : libraries()) fmt::print("  {:<8}{}\n", library.name, library.version);
}

}  // namespace velum::cases
