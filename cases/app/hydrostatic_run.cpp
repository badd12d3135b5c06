#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>

#include "cases/app/assumptions.hpp"
#include "cases/app/hydrostatic_scene.hpp"
#include "cases/app/material_range.hpp"
#include "cases/app/membrane_profile.hpp"

namespace velum::cases {

void run_hydrostatic(Scene const& scene, std::filesystem::path const& out)
{
  auto const start = std::chrono::steady_clock::now();
  Derived const d = derive(scene);
  HydrostaticScene s = make_membrane_scene(scene, d);
  find_equilibrium(s, scene, d);
  double const dx = d.units.dx;
  double const wall_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  auto profile = start_profile(out);
  append_profile(profile, s.membrane, dx, 0);
  int const middle = structure::middle_node(s.membrane);
  double const deflection =
      dx * (s.membrane.reference[2 * middle] - s.membrane.position[2 * middle]);
  double const force = core::to_si_force(d.units, symmetry(scene), s.report.patch.force);
  double const penetration = dx * s.report.patch.penetration;
  auto const& material = scene.materials.at(scene.membrane->material);
  StretchRecord stretch;
  note_stretch(stretch, s.membrane, material);
  core::Summary summary{{{"centre_deflection_hydrostatic", deflection, "m"},
                         {"seat_force", force, "N"},
                         {"penetration", penetration, "m"},
                         {"stretch_max", stretch.largest, "1"},
                         {"iterations", double(s.report.iterations), "1"},
                         {"wall_time", wall_time, "s"}},
                        assumptions(scene, d, 0)};
  add_range(summary.assumptions, stretch, material);
  core::write_summary(out / "summary.json", summary);
  for (auto const& [name, sentence] : summary.assumptions) spdlog::info("{}: {}", name, sentence);
  spdlog::info(
      "Equilibrium at {:.4g} kPa: centre deflection {:.4f} mm, seat force {:.4g} N, penetration "
      "{:.3g} um, {} linear solves in {:.2f} s",
      inlet_pressure(scene, 0) / 1e3, 1e3 * deflection, force, 1e6 * penetration,
      s.report.iterations, wall_time);
}

}  // namespace velum::cases
