#include <fmt/format.h>

#include <cstdio>

#include "cases/app/commands.hpp"
#include "cases/app/contact_penalty.hpp"
#include "cases/app/picture.hpp"
#include "cases/app/stop.hpp"
#include "core/output/folder.hpp"

namespace velum::cases {
namespace {

void print(PenaltyRow const& row)
{
  fmt::print(
      "{:<21} k {:8.2e} Pa/m  penetration {:8.2e} um  errors: force {:7.1e}, pressure {:7.1e}  "
      "{:3} solves, {:4} linear\n",
      row.method, row.stiffness, 1e6 * row.penetration, row.force_error, row.largest_error,
      row.solves, row.iterations);
  std::fflush(stdout);
}

}  // namespace

void contact_penalty_command(Options const& options)
{
  int const rings = options.cells > 0 ? options.cells : options.quick ? 12 : 22;
  auto const out = core::make_folder(options.out.empty() ? std::filesystem::path("results") /
                                                               "limits_contact_penalty"
                                                         : options.out);
  catch_stop_signals();
  fmt::print("disc pressed on a ring seat, {} rings of triangles\n", rings);
  std::fflush(stdout);
  std::vector<PenaltyRow> rows;
  contact_penalty(rings, options.quick ? 1 : 2, [&](PenaltyRow const& row) {
    rows.push_back(row);
    core::write_atomically(out / "penalty.csv", csv(rows));
    if (!options.quiet) print(row);
    if (stop_requested()) throw Stopped("Stopped by a signal; what was found is in penalty.csv.");
  });
  fmt::print("{}\n", (out / "penalty.csv").string());
  draw("penalty.py", out);
}

}  // namespace velum::cases
