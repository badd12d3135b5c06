#include "cases/app/preflight.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace velum::cases {
namespace {

Row memory_row(Scene const& scene, double cells)
{
  // Two copies of nine populations, a mask, and the host's fields for output.
  double const real = scene.lattice.precision == Precision::single_ ? 4 : 8;
  double const bytes = cells * (2 * 9 * real + 1 + 4 * 8);
  double const machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  Row row{"memory", bytes / 1e6, "MB", Verdict::ok, ""};
  if (bytes > 0.8 * machine) {
    row.verdict = Verdict::red;
    row.remark =
        fmt::format("this machine has {:.3g} GB: lattice.dx >= \"{:.3g} um\"", machine / 1e9,
                    1e6 * scene.lattice.dx * std::sqrt(bytes / (0.8 * machine)));
  }
  return row;
}

Row output_row(Scene const& scene, double cells)
{
  // Pressure, two velocities and a label for each cell, uncompressed.
  double const dumps = std::floor(scene.run.end / scene.run.output_every) + 1;
  Row row{"output", dumps * cells * 4 * 8 / 1e6, "MB", Verdict::ok,
          fmt::format("{:.0f} dumps", dumps)};
  if (row.value > 1e4) {
    row.verdict = Verdict::warn;
    row.remark += fmt::format(": run.output_every >= \"{:.3g} ms\"",
                              1e3 * scene.run.output_every * row.value / 1e4);
  }
  return row;
}

Row time_row(Scene const& scene, Derived const& d, double cells, double mlups)
{
  double const seconds = static_cast<double>(d.steps) * cells / (1e6 * mlups);
  Row row{"time to finish, fluid", seconds < 120 ? seconds : seconds / 60,
          seconds < 120 ? "s" : "min", Verdict::ok,
          fmt::format("at {:.3g} MLUPS, measured now{}", mlups,
                      scene.membrane ? "; the membrane comes on top" : "")};
  if (scene.run.steady > 0) row.remark += "; less where the flow becomes steady before run.end";
  if (seconds > 3600) {
    row.verdict = seconds > 86400 ? Verdict::red : Verdict::warn;
    // Cells and steps together grow with the third power of the resolution.
    row.remark += fmt::format(": an hour needs lattice.dx >= \"{:.3g} um\"",
                              1e6 * scene.lattice.dx * std::cbrt(seconds / 3600));
  }
  return row;
}

}  // namespace

std::vector<Row> cost_rows(Scene const& scene, Derived const& d, double mlups)
{
  double const cells = static_cast<double>(d.grid.nx) * d.grid.ny;
  return {{fmt::format("cells, {} x {}", d.grid.nx, d.grid.ny), cells, "", Verdict::info, ""},
          {"steps", static_cast<double>(d.steps), "", Verdict::info, ""},
          memory_row(scene, cells),
          output_row(scene, cells),
          time_row(scene, d, cells, mlups)};
}

}  // namespace velum::cases
