#include "cases/app/lumped_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>

#include "cases/app/assumptions.hpp"
#include "cases/app/history.hpp"
#include "cases/app/lumped_scene.hpp"
#include "cases/app/material_range.hpp"
#include "cases/app/membrane_profile.hpp"
#include "cases/app/network_columns.hpp"
#include "cases/app/progress.hpp"
#include "cases/app/stop.hpp"
#include "cases/app/valve_report.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "core/output/series.hpp"

namespace velum::cases {
namespace {

constexpr long look_every = 200;  // steps

std::vector<core::Column> columns(Scene const& scene)
{
  return valve_columns(scene, {{"gap", "m"}, {"flow", "m3/s"}});
}

std::vector<double> row(LumpedScene const& s, Scene const& scene, double time)
{
  auto const& units = s.derived.units;
  auto const& state = s.state;
  auto const pressure = [&](int k) {
    return core::to_si_pressure(units, ibm::pressure(state.network, k));
  };
  auto const patch = contact::contact_patch(state.seat->contact, state.seat->markers);
  std::vector<double> r = {
      pressure(state.above),
      pressure(state.outside),
      pressure(state.inside),
      core::to_si_length(units,
                         state.membrane.position[2 * structure::middle_node(state.membrane)]),
      core::to_si_length(units, patch.penetration),
      core::to_si_force(units, symmetry(scene), patch.force),
      core::to_si_length(units, state.gap.least),
      core::to_si_flow_rate(units, symmetry(scene), outflow(s)),
  };
  auto const more = network_row(state.network, s.key, scene, s.derived, time);
  r.insert(r.end(), more.begin(), more.end());
  add_stop(r, s.stop, s.state.membrane, s.derived);
  return r;
}

/// The rows of a run, in memory and on the disk, and the membrane's shape at times.
struct Output {
  History history;
  core::Series series, profile;
  double next_profile = 0;
};

void record(Output& out, LumpedScene const& s, Scene const& scene, double time)
{
  out.history.time.push_back(time);
  out.history.rows.push_back(row(s, scene, time));
  core::append(out.series, time, out.history.rows.back());
  double const dt = s.derived.units.dt, almost = time + dt;
  if (almost < out.next_profile) return;
  append_profile(out.profile, s.state.membrane, s.derived.units.dx, time);
  while (out.next_profile <= almost) out.next_profile += scene.run.output_every;
}

/// Diameter of the seat at the narrowest place, m; 0 in a plane.
double seat_diameter(LumpedScene const& s, Scene const& scene)
{
  if (symmetry(scene) != core::Symmetry::axisymmetric) return 0;
  return 2 * core::to_si_length(s.derived.units, s.state.gap.at[1]);
}

}  // namespace

void run_lumped(Scene const& scene, RunOptions const& options)
{
  auto const clock_start = std::chrono::steady_clock::now();
  Derived const d = derive(scene);
  HydrostaticScene start = make_membrane_scene(scene, d);
  find_equilibrium(start, scene, d);
  auto assumed = assumptions(scene, d, 0);
  for (auto const& [name, sentence] : assumed) spdlog::info("{}: {}", name, sentence);
  auto s = make_lumped_scene(scene, d, start);
  Output out{{columns(scene), {}, {}},
             core::start_series(options.out / "series.csv", columns(scene)),
             start_profile(options.out)};
  double const seat = seat_diameter(s, scene);
  double const dt = d.units.dt;
  long const total = std::lround(scene.run.end / dt), settle = std::lround(scene.run.settle / dt);
  long const sample = std::max<long>(1, std::lround(scene.run.sample_every / dt));
  auto const elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - clock_start).count();
  };
  auto const& material = scene.materials.at(scene.membrane->material);
  StretchRecord stretch;
  note_stretch(stretch, s.state.membrane, scene);
  ProgressLine progress(options.quiet);
  record(out, s, scene, 0);
  bool stopped = false;
  double time = 0;
  for (long n = 1; n <= total && !stopped; ++n) {
    time = double(n) * dt;
    set_network(s.state.network, s.key, scene, d, time, n > settle);
    try {
      ibm::step(s.state, 1);
    } catch (core::Divergence const& failure) {
      throw core::Divergence(fmt::format("Diverged at step {} (t = {:.4g} s), body membrane: {}.",
                                         n, time, failure.what()));
    }
    if (n % look_every == 0) {
      progress.show({.time = time,
                     .end = double(total) * dt,
                     .coupling = fmt::format(
                         "gap {:.1f} um", 1e6 * core::to_si_length(d.units, s.state.gap.least))});
      stopped = stop_requested();
    }
    if (n % sample == 0 || n == total || stopped) {
      record(out, s, scene, time);
      note_stretch(stretch, s.state.membrane, scene);
    }
  }
  progress.finish();
  add_range(assumed, stretch, material);
  auto const report = valve_report(scene, out.history, {seat, stretch});
  if (!report.kv.empty()) core::write_atomically(options.out / "kv.csv", report.kv);
  assumed.insert(report.rules.begin(), report.rules.end());
  auto const& names = out.history.columns;
  auto const& last = out.history.rows.back();
  core::Summary summary{{}, assumed};
  for (std::size_t k = 0; k < names.size(); ++k)
    summary.figures.push_back({names[k].name, last[k], names[k].unit});
  summary.figures.insert(summary.figures.end(), report.figures.begin(), report.figures.end());
  for (auto& figure : figures(stretch)) summary.figures.push_back(std::move(figure));
  summary.figures.push_back({"wall_time", elapsed(), "s"});
  core::write_summary(options.out / "summary.json", summary);
  if (stopped)
    throw Stopped(
        fmt::format("Stopped by a signal at t = {:.4g} s; the results until then are in "
                    "{}.",
                    time, options.out.string()));
  spdlog::info("{:.4g} ms in {:.1f} s: pressure above {:.4g} kPa, flow {:.4g} l/h, gap {:.4g} um",
               1e3 * time, elapsed(), last[0] / 1e3, 3.6e6 * last[7], 1e6 * last[6]);
  spdlog::info("{}", report.text);
  spdlog::info("results: {}", options.out.string());
}

}  // namespace velum::cases
