#include "cases/app/fluid_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "cases/app/assumptions.hpp"
#include "cases/app/dump.hpp"
#include "cases/app/lattice_scene.hpp"
#include "cases/app/progress.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/output/series.hpp"
#include "lbm/bounce_back.hpp"
#include "lbm/observe.hpp"
#include "lbm/stream_and_collide.hpp"

namespace velum::cases {

namespace {

template <class Real>
lbm::LinkList resting_walls(LatticeScene<Real> const& s)
{
  std::vector<lbm::Link> links;
  for (lbm::WallHit const& h : s.wall_hits) links.push_back(lbm::link_at(s.fluid, s.walls, h));
  lbm::LinkList list;
  lbm::upload(list, links);
  return list;
}

template <class Real>
void march(Scene const& scene, RunOptions const& options)
{
  double const smagorinsky = smagorinsky_constant(scene, false);
  auto s = make_lattice_scene<Real>(scene, smagorinsky);
  auto const about = assumptions(scene, s.derived, smagorinsky);
  for (auto const& [name, sentence] : about) spdlog::info("{}: {}", name, sentence);
  auto const walls = resting_walls(s);
  auto const& units = s.derived.units;
  auto fields = core::create_fields(options.out, s.derived.grid, about);
  std::vector<core::Column> columns = {{"speed_max", "m/s"}};
  for (auto const& o : s.openings) {
    std::string const name = fmt::format("{}_{}", o.boundary, columns.size() / 2);
    columns.push_back({name + "_flow", "m3/s"});
    columns.push_back({name + "_traction", "Pa"});
  }
  auto series = core::start_series(options.out / "series.csv", columns);
  ProgressLine progress(options.quiet);
  auto const begin = std::chrono::steady_clock::now();
  long const total = std::lround(scene.run.end / units.dt);
  long const dump = std::max<long>(1, std::lround(scene.run.output_every / units.dt));
  double mach = 0, cells = 1;
  std::vector<core::Figure> figures;
  for (long n = 0; n <= total; ++n) {
    double const time = double(n) * units.dt;
    if (n % dump == 0 || n == total) {
      auto const seen = lbm::observe(s.fluid);
      cells = double(seen.cells);
      if (seen.not_finite > 0 || seen.speed_max * std::numbers::sqrt3 > 1)
        throw core::Divergence(fmt::format(
            "Diverged at step {}: the fluid is not finite or faster than its sound, worst in cell "
            "({}, {}). Likely cause: tau - 1/2 = {:.2g} is too small for this collision, or "
            "lattice.mach is too large.",
            n, seen.worst_i, seen.worst_j, s.derived.tau_minus_half));
      mach = std::max(mach, seen.speed_max * std::numbers::sqrt3);
      std::vector<double> values = {core::to_si_velocity(units, seen.speed_max)};
      for (auto const& o : s.openings) {
        values.push_back(core::to_si_flow_rate(units, symmetry(scene), o.opening.mass_flow));
        values.push_back(core::to_si_pressure(units, o.opening.traction));
      }
      core::append(series, time, values);
      core::write_fields(fields, time, fluid_fields(s.fluid, units), {});
      figures.clear();
      for (std::size_t k = 0; k < columns.size(); ++k)
        figures.push_back({columns[k].name, values[k], columns[k].unit});
      double const elapsed =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      progress.show({.time = time,
                     .end = scene.run.end,
                     .mlups = double(n) * cells / std::max(elapsed, 1e-9) / 1e6,
                     .mach = mach});
      if (stop_requested())
        throw Stopped(fmt::format("Stopped by a signal at t = {:.4g} s.", time));
    }
    if (n == total) break;
    lbm::fill_ghosts(s.fluid);
    lbm::bounce_back(s.fluid, walls, {});
    for (auto& o : s.openings)
      lbm::apply(s.fluid, o.opening,
                 lattice_target(scene, s.derived, *find_boundary(scene, o.boundary), time));
    lbm::stream_and_collide(s.fluid);
  }
  progress.finish();
  double const elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  auto const eddy = lbm::eddy_viscosity(s.fluid);
  figures.push_back({"mach_max", mach, "1"});
  figures.push_back(
      {"eddy_viscosity_mean", core::to_si_kinematic_viscosity(units, eddy.mean), "m2/s"});
  figures.push_back(
      {"eddy_viscosity_max", core::to_si_kinematic_viscosity(units, eddy.max), "m2/s"});
  figures.push_back({"wall_time", elapsed, "s"});
  figures.push_back({"mlups", double(total) * cells / elapsed / 1e6, "1e6/s"});
  core::write_summary(options.out / "summary.json", {figures, about});
  for (auto const& f : figures) spdlog::info("{} = {:.6g} {}", f.name, f.value, f.unit);
  spdlog::info("results: {}", (options.out / "run.xmf").string());
}

}  // namespace

void run_fluid(Scene const& scene, RunOptions const& options)
{
  scene.lattice.precision == Precision::double_ ? march<double>(scene, options)
                                                : march<float>(scene, options);
}

}  // namespace velum::cases
