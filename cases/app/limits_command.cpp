#include "cases/app/commands.hpp"
#include "cases/app/limits.hpp"
#include "cases/app/picture.hpp"
#include "cases/app/scene_words.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace velum::cases {
namespace {

constexpr double reynolds_of_mach_limit = 1e4;

LimitMap const& find_map(std::string const& name)
{
  auto const& maps = limit_maps();
  auto const found =
      std::find_if(maps.begin(), maps.end(), [&](LimitMap const& m) { return m.name == name; });
  if (found != maps.end()) return *found;
  std::vector<std::string> names;
  for (auto const& map : maps) names.push_back(map.name);
  names.push_back("contact_penalty");
  std::string const near = core::nearest(name, names);
  throw core::InputError(fmt::format(
      "limits: {} is not a map{} Maps: {}.", name,
      near.empty() ? "." : fmt::format("; did you mean \"{}\"?", near), core::any_of(names)));
}

void print(LimitRow const& row)
{
  double const value = row.quantity == "mach" ? row.mach : row.reynolds;
  std::string const limit = row.bound == "none"  ? fmt::format("at least {:.3g}", value)
                            : row.bound == "all" ? fmt::format("below {:.3g}", value)
                                                 : fmt::format("{:.3g}", value);
  std::string const given = row.quantity == "mach" ? fmt::format("Re {:.3g}", row.reynolds)
                                                   : fmt::format("Mach {:.3g}", row.mach);
  fmt::print("{:<16} LES {:<3}  {:<10} largest {:<8} {:<18} tau - 1/2 = {:.2g}\n",
             word(row.collision), row.les ? "on" : "off", given,
             row.quantity == "mach" ? "Mach" : "Re", limit, row.tau_minus_half);
  std::fflush(stdout);
}

}  // namespace

void limits_command(Options const& options)
{
  if (options.map == "contact_penalty") return contact_penalty_command(options);
  auto const& map = find_map(options.map);
  int const cells = options.cells > 0 ? options.cells : options.quick ? map.cells / 2 : map.cells;
  auto const out = core::make_folder(options.out.empty()
                                         ? std::filesystem::path("results") / ("limits_" + map.name)
                                         : options.out);
  catch_stop_signals();
  std::vector<double> const machs =
      options.quick ? std::vector{0.1} : std::vector{0.05, 0.1, 0.2, 0.3};
  fmt::print("{}, {} cells across\n", map.what, cells);
  std::vector<LimitRow> rows;
  auto const add = [&](LimitRow row) {
    rows.push_back(std::move(row));
    core::write_atomically(out / "limits.csv", csv(map.name, cells, rows));
    if (!options.quiet) print(rows.back());
  };
  for (auto const& [name, collision] : words(Collision{})) {
    auto const sample = map.scene({collision, false, 0.1, 1e3}, cells);
    if (!lbm::is_defined(collision, directions(sample.lattice.stencil))) continue;
    for (bool const les : {false, true}) {
      for (double const mach : machs) add(largest_reynolds(map, {collision, les, mach, 0}, cells));
      add(largest_mach(map, {collision, les, 0, reynolds_of_mach_limit}, cells));
    }
  }
  fmt::print("{}\n", (out / "limits.csv").string());
  draw("limits.py", out);
}

}  // namespace velum::cases
