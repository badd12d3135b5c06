#include "cases/app/format.hpp"
#include "cases/app/preflight.hpp"
#include "cases/app/scene_words.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace velum::cases {
namespace {

/// Pressure, density, three components of velocity and a label for each cell, uncompressed.
int output_bytes(Scene const& scene) { return 4 + 4 + 3 * (dimensions(scene) == 3 ? 4 : 8) + 4; }

/// Of the populations, one copy, in place.
int bytes_per_cell(Lattice const& lattice)
{
  return with_format(lattice, []<class Real, class L, class Stored>() {
    return L::Q * static_cast<int>(sizeof(Stored));
  });
}

Row memory_row(Scene const& scene, double cells)
{
  // The populations, a mask, the share of the eddy viscosity, and the host's copy for output.
  int const eddy = scene.les.model == LesModel::off
                       ? 0
                       : with_format(scene.lattice, []<class Real, class L, class Stored>() {
                           return static_cast<int>(sizeof(Real));
                         });
  double const bytes = cells * (bytes_per_cell(scene.lattice) + 1 + eddy + sizeof(lbm::CellState) +
                                output_bytes(scene));
  double const machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  Row row{"memory", bytes / 1e6, "MB", Verdict::ok, ""};
  if (bytes > 0.8 * machine) {
    row.verdict = Verdict::red;
    row.remark = fmt::format(
        "this machine has {:.3g} GB: lattice.dx >= \"{:.3g} um\"", machine / 1e9,
        1e6 * scene.lattice.dx * std::pow(bytes / (0.8 * machine), 1.0 / dimensions(scene)));
  }
  return row;
}

Row output_row(Scene const& scene, double cells)
{
  double const dumps = std::floor(scene.run.end / scene.run.output_every) + 1;
  Row row{"output", dumps * cells * output_bytes(scene) / 1e6, "MB", Verdict::ok,
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
    double const power = dimensions(scene) + 1;  // of the resolution: cells, and steps
    row.remark += fmt::format(": an hour needs lattice.dx >= \"{:.3g} um\"",
                              1e6 * scene.lattice.dx * std::pow(seconds / 3600, 1 / power));
  }
  return row;
}

}  // namespace

std::vector<Row> cost_rows(Scene const& scene, Derived const& d, double mlups)
{
  double const cells = static_cast<double>(d.grid.nx) * d.grid.ny * d.grid.nz;
  std::string const depth = dimensions(scene) == 3 ? fmt::format(" x {}", d.grid.nz) : "";
  return {{fmt::format("cells, {} x {}{}", d.grid.nx, d.grid.ny, depth), cells, "", Verdict::info,
           "solid ones included"},
          {"populations per cell", double(bytes_per_cell(scene.lattice)), "B", Verdict::info,
           fmt::format("{}, {} precision, one copy", word(scene.lattice.stencil),
                       word(scene.lattice.precision))},
          {"steps", static_cast<double>(d.steps), "", Verdict::info, ""},
          memory_row(scene, cells),
          output_row(scene, cells),
          time_row(scene, d, cells, mlups)};
}

}  // namespace velum::cases
