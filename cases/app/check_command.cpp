#include "cases/app/body_model.hpp"
#include "cases/app/body_run.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/derived.hpp"
#include "cases/app/preflight.hpp"
#include "cases/app/scene.hpp"
#include "cases/app/scene_words.hpp"
#include "cases/app/speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

void print_section(char const* title, std::vector<Row> const& rows)
{
  if (!rows.empty()) fmt::print("{}\n{}", title, table(rows));
}

std::ptrdiff_t count(std::vector<Row> const& rows, Verdict verdict)
{
  return std::count_if(rows.begin(), rows.end(),
                       [&](Row const& row) { return row.verdict == verdict; });
}

/// What a run of a body would assume, and what it would solve.
void check_body(Options const& options)
{
  auto const scene = read_body_scene(options.scene, options.set);
  if (scene.reference) load_body_table(scene);
  fmt::print("{}: {}, structure\n", scene.source.file, scene.name);
  for (auto const& [name, sentence] : body_assumptions(scene))
    fmt::print("  {:<10} {}\n", name, sentence);
  std::string const states =
      scene.march ? fmt::format("{:.0f} steps", std::ceil(scene.march->end / scene.march->step))
                  : fmt::format("{} pressures, {} volumes", scene.load.pressures.size(),
                                scene.load.volumes.size());
  fmt::print("  {:<10} {}; {} unknowns\n", "states", states, unknowns(scene));
}

}  // namespace

void check_command(Options const& options)
{
  if (is_body_scene(options.scene, options.set)) return check_body(options);
  Scene const scene = read_scene(options.scene, options.set);
  Derived const derived = derive(scene);
  bool const marched = scene.fidelity != Fidelity::hydrostatic;

  std::vector<Row> fluid, cost;
  if (marched) {
    fluid = fluid_rows(scene, derived);
    cost = cost_rows(scene, derived, measured_mlups(scene, derived));
  }
  auto const membrane = membrane_rows(scene, derived);

  fmt::print("{}: {}, {}\n", scene.source.file, scene.name, word(scene.fidelity));
  print_section("fluid", fluid);
  print_section("membrane and seat", membrane);
  print_section("cost", cost);
  fmt::print("fidelity that would do\n  {}\n", fidelity_advice(scene));

  auto const total = [&](Verdict verdict) {
    return count(fluid, verdict) + count(membrane, verdict) + count(cost, verdict);
  };
  fmt::print("{} red, {} to watch\n", total(Verdict::red), total(Verdict::warn));
}

}  // namespace velum::cases
