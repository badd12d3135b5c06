#include "cases/app/fluid_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "cases/app/assumptions.hpp"
#include "cases/app/fluid_guard.hpp"
#include "cases/app/fluid_record.hpp"
#include "cases/app/format.hpp"
#include "cases/app/progress.hpp"
#include "cases/app/reference.hpp"
#include "cases/app/steady.hpp"
#include "cases/app/stop.hpp"

namespace velum::cases {

namespace {

double seconds_since(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

long steps_of(double interval, double dt) { return std::max<long>(1, std::lround(interval / dt)); }

SteadyTest steady_test(Scene const& scene, Derived const& d)
{
  double const side = std::max({d.grid.nx, d.grid.ny, d.grid.nz}) * d.grid.dx;
  double const length =
      scene.reference && scene.reference->length > 0 ? scene.reference->length : side;
  return {scene.run.steady, steps_of(length / d.velocity, d.units.dt)};
}

/// What a march has seen so far.
struct Watch {
  double mach = 0;
  long cells = 1, steps = 0;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();

  double mlups() const
  {
    return double(steps) * double(cells) / std::max(seconds_since(begin), 1e-9) / 1e6;
  }
};

template <class Real, class L, class Stored>
lbm::Observation look(Watch& watch, FluidScene<Real, L, Stored> const& s, long step)
{
  auto const seen = lbm::observe(s.lattice.fluid);
  if (std::string const what = fault(seen); !what.empty())
    diverge(s.lattice.derived, what, lbm::worst_cell(s.lattice.fluid), step);
  watch.cells = seen.cells;
  watch.steps = step;
  watch.mach = std::max(watch.mach, seen.speed_max * std::numbers::sqrt3);
  return seen;
}

/// The last row of the series, then what the march as a whole was like.
template <class Real, class L, class Stored>
std::vector<core::Figure> figures_of(FluidRecord const& record, Watch const& watch,
                                     FluidScene<Real, L, Stored> const& s)
{
  auto const& [columns, time, rows] = record.history;
  auto const& units = s.lattice.derived.units;
  std::vector<core::Figure> figures;
  for (std::size_t k = 0; k < columns.size(); ++k)
    figures.push_back({columns[k].name, rows.back()[k], columns[k].unit});
  auto const eddy = lbm::eddy_viscosity(s.lattice.fluid);
  figures.push_back({"end_time", time.back(), "s"});
  figures.push_back({"mach_max", watch.mach, "1"});
  figures.push_back(
      {"eddy_viscosity_mean", core::to_si_kinematic_viscosity(units, eddy.mean), "m2/s"});
  figures.push_back(
      {"eddy_viscosity_max", core::to_si_kinematic_viscosity(units, eddy.max), "m2/s"});
  figures.push_back({"steps", double(watch.steps), "1"});
  figures.push_back({"wall_time", seconds_since(watch.begin), "s"});
  figures.push_back({"mlups", watch.mlups(), "1e6/s"});
  return figures;
}

template <class Real, class L, class Stored>
core::Summary march(Scene const& scene, RunOptions const& options)
{
  double const smagorinsky = smagorinsky_constant(scene, false);
  auto s = make_fluid_scene<Real, L, Stored>(scene, smagorinsky);
  auto const& d = s.lattice.derived;
  check_time_step(scene, d);
  ReferenceData const data = scene.reference ? load_reference(scene) : ReferenceData{};
  core::Summary summary{{}, assumptions(scene, d, smagorinsky)};
  if (scene.reference) summary.assumptions["reference"] = data.note;
  bool const heard = !options.out.empty();
  if (heard)
    for (auto const& [name, sentence] : summary.assumptions) spdlog::info("{}: {}", name, sentence);

  auto record = start_record(s, options.out, summary.assumptions);
  ProgressLine progress(options.quiet || !heard);
  SteadyTest steady = steady_test(scene, d);
  double const dt = d.units.dt;
  long const total = std::lround(scene.run.end / dt);
  long const dump = steps_of(scene.run.output_every, dt);
  long const sample = steps_of(scene.run.sample_every, dt);
  Watch watch;
  bool rested = false;
  for (long n = 0;; ++n) {
    double const time = double(n) * dt;
    rested = steady.due(n) && steady.passed(lbm::cell_states(s.lattice.fluid));
    bool const last = n == total || rested || stop_requested();
    bool const sampling = n % sample == 0 || last;
    if (sampling || n % guard_every == 0) {
      auto const seen = look(watch, s, n);
      if (sampling) add_sample(record, s, seen, time);
      if (n % dump == 0 || last) add_dump(record, s, time);
      progress.show(
          {.time = time, .end = scene.run.end, .mlups = watch.mlups(), .mach = watch.mach});
    }
    if (last) break;
    step(s, time);
  }
  progress.finish();
  double const end = record.history.time.back();
  if (stop_requested()) throw Stopped(fmt::format("Stopped by a signal at t = {:.4g} s.", end));

  summary.figures = figures_of(record, watch, s);
  if (scene.run.steady > 0) summary.figures.push_back({"steady_change", steady.change(), "1"});
  summary.assumptions["end"] =
      rested ? fmt::format(
                   "steady at t = {:.4g} s: the velocities changed by {:.2g} of themselves "
                   "in the last {:.4g} s",
                   end, steady.change(), double(steady.period()) * dt)
             : fmt::format("run.end reached at t = {:.4g} s", end);
  if (scene.reference) {
    Sampled const flow = sampled(s);
    for (auto const& f : compare(data, {scene, d.units, flow, record.history, end}))
      summary.figures.push_back(f);
  }
  compare_figure(scene, summary);
  return summary;
}

}  // namespace

core::Summary march_fluid(Scene const& scene, RunOptions const& options)
{
  return with_format(scene.lattice, [&]<class Real, class L, class Stored>() {
    return march<Real, L, Stored>(scene, options);
  });
}

void run_fluid(Scene const& scene, RunOptions const& options)
{
  auto const summary = march_fluid(scene, options);
  core::write_summary(options.out / "summary.json", summary);
  spdlog::info("end: {}", summary.assumptions.at("end"));
  for (auto const& f : summary.figures) spdlog::info("{} = {:.6g} {}", f.name, f.value, f.unit);
  spdlog::info("results: {}", (options.out / "run.xmf").string());
}

}  // namespace velum::cases
