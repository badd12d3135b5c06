#include "cases/app/coupled_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "cases/app/assumptions.hpp"
#include "cases/app/certificate.hpp"
#include "cases/app/dump.hpp"
#include "cases/app/material_range.hpp"
#include "cases/app/network_columns.hpp"
#include "cases/app/progress.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/output/series.hpp"
#include "structure/static_solve.hpp"
#include "structure/volume_control.hpp"

namespace velum::cases {

namespace {

constexpr long guard_every = 200;     // steps
constexpr int samples_per_run = 400;  // rows of series.csv at least
constexpr double window_share = 0.5;  // of the settling stage: over which leaks are averaged

std::vector<core::Column> columns(Scene const& scene)
{
  std::vector<core::Column> c = {{"pressure_above", "Pa"},
                                 {"pressure_outside", "Pa"},
                                 {"pressure_inside", "Pa"},
                                 {"centre", "m"},
                                 {"penetration", "m"},
                                 {"seat_force", "N"},
                                 {"outflow", "m3"},
                                 {"inflow", "m3"},
                                 {"leak_through_seat", "m3"},
                                 {"leak_through_membrane", "m3"},
                                 {"volume_inside", "m3"},
                                 {"speed_max", "m/s"},
                                 {"sealed", "1"},
                                 {"gap", "m"},
                                 {"flow", "m3/s"},
                                 {"gap_by_law", "1"}};
  auto const more = network_columns(scene);
  c.insert(c.end(), more.begin(), more.end());
  return c;
}

std::vector<double> row(Measurement const& m)
{
  std::vector<double> r = {m.pressure_above,
                           m.pressure_outside,
                           m.pressure_inside,
                           m.centre,
                           m.penetration,
                           m.seat_force,
                           m.outflow,
                           m.inflow,
                           m.through_seat,
                           m.through_membrane,
                           m.volume_inside,
                           m.speed_max,
                           m.sealed ? 1.0 : 0.0,
                           m.gap,
                           m.flow,
                           m.gap_by_law};
  r.insert(r.end(), m.network.begin(), m.network.end());
  return r;
}

double jump(Measurement const& m)
{
  return std::min(m.pressure_above, m.pressure_outside) - m.pressure_inside;
}

/// Files that grow while a run marches.
struct Output {
  core::FieldsFile fields;
  core::Series series;
  double next_dump = 0;
};

template <class Real, template <class> class Body>
void record(Output& out, CoupledScene<Real, Body> const& s, Measurement const& m,
            double output_every)
{
  core::append(out.series, m.time, row(m));
  double const almost = s.derived.units.dt;  // a stage ends up to half a step beside its time
  if (m.time + almost < out.next_dump) return;
  core::write_fields(out.fields, m.time, fluid_fields(s.state.fluid, s.derived.units),
                     membrane_curves(s));
  while (out.next_dump <= m.time + almost) out.next_dump += output_every;
}

template <class Real, template <class> class Body>
std::string coupling_in_words(ibm::Coupled<Real, Body> const& s)
{
  bool const implicit = std::holds_alternative<structure::ImplicitStepper>(s.stepper);
  return fmt::format("{} links, {}", s.body.exchange.link_count,
                     implicit ? "implicit" : fmt::format("{} sub-steps", s.substeps));
}

/// One step; where the membrane fails in it, the sentence gets the step and the likely cause.
template <class Real, template <class> class Body>
void step(CoupledScene<Real, Body>& s, long n)
{
  try {
    ibm::step(s.state);
  } catch (core::Divergence const& failure) {
    throw core::Divergence(
        fmt::format("Diverged at step {} (t = {:.4g} s), body membrane: {}. Likely cause: {}.", n,
                    core::to_si_time(s.derived.units, double(n)), failure.what(), likely_cause(s)));
  }
}

/// Volume that the driven membrane has swept over that of its equilibrium with the same middle,
/// less 1; the lower face is parallel to the mid-surface, whose volumes these are.
template <class Real, template <class> class Body>
double against_rest(CoupledScene<Real, Body> const& s, HydrostaticScene const& start)
{
  auto rest = s.state.membrane;
  structure::static_solve(rest, start.loads);
  auto const inflation = structure::inflation(rest);
  return inflation.volume(s.state.membrane.position) / inflation.volume(rest.position) - 1;
}

template <class Real, template <class> class Body>
Certificate march(Scene const& scene, RunOptions const& options, HydrostaticScene const& start,
                  double smagorinsky)
{
  auto const clock_start = std::chrono::steady_clock::now();
  auto s = make_coupled_scene<Real, Body>(scene, start, smagorinsky);
  Derived const& d = s.derived;
  double const dt = d.units.dt;
  long const settle = std::lround(scene.run.settle / dt), total = std::lround(scene.run.end / dt);
  long const sample = std::clamp(std::lround(scene.run.sample_every / dt), 1L,
                                 std::max(1L, total / samples_per_run));
  long const window = std::lround(double(settle) * (1 - window_share));
  Output out{core::create_fields(options.out, d.grid, assumptions(scene, d, smagorinsky)),
             core::start_series(options.out / "series.csv", columns(scene)), 0};
  ProgressLine progress(options.quiet);
  Flows flows;

  Certificate c;
  c.inlet = inlet_pressure(scene, scene.run.settle);
  c.outlet = outlet_pressure(scene, scene.run.settle);
  c.centre_start = core::to_si_length(d.units, start.membrane.reference[0]);
  c.centre_hydrostatic = core::to_si_length(d.units, start.membrane.position[0]);
  c.has_shut = total > settle;
  c.least_jump_shut = c.inlet - c.outlet;
  auto const elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - clock_start).count();
  };
  double const cells = double(lbm::observe(s.state.fluid).cells);

  auto const& material = scene.materials.at(scene.membrane->material);
  StretchRecord stretch;
  note_stretch(stretch, s.state.membrane, material);

  Measurement now = measure(s, scene, flows, 0);
  if (!s.driven.empty()) c.driven = start_record(now);
  record(out, s, now, scene.run.output_every);
  c.window_begin = c.settled = now;
  bool stopped = false;
  for (long n = 1; n <= total && !stopped; ++n) {
    set_targets(s, scene, double(n) * dt, n > settle);
    drive(s, scene, double(n) * dt);
    step(s, n);
    add_flows(flows, s);
    if (n % guard_every == 0 || n == total) {
      lbm::Observation const seen = lbm::observe(s.state.fluid);
      guard(s, seen, n);
      c.mach_max = std::max(c.mach_max, seen.speed_max * std::numbers::sqrt3);
      c.speed_max = std::max(c.speed_max, core::to_si_velocity(d.units, seen.speed_max));
      double const mlups = double(n) * cells / elapsed() / 1e6;
      progress.show({.time = double(n) * dt,
                     .end = double(total) * dt,
                     .mlups = mlups,
                     .mach = c.mach_max,
                     .coupling = coupling_in_words(s.state)});
      stopped = stop_requested();
    }
    if (n % sample == 0 || n == total || n == settle || n == window || stopped) {
      now = measure(s, scene, flows, double(n) * dt);
      record(out, s, now, scene.run.output_every);
      note_stretch(stretch, s.state.membrane, material);
      if (c.driven) note(*c.driven, now);
      if (n <= window) c.window_begin = now;
      if (n <= settle) c.settled = now;
      if (n > settle) c.least_jump_shut = std::min(c.least_jump_shut, jump(now));
      c.penetration_max = std::max(c.penetration_max, now.penetration);
    }
  }
  progress.finish();
  c.shut = now;
  if (c.driven) c.driven->static_shape = against_rest(s, start);
  if (smagorinsky > 0) {
    auto const eddy = lbm::eddy_viscosity(s.state.fluid);
    c.eddy_mean = core::to_si_kinematic_viscosity(d.units, eddy.mean);
    c.eddy_max = core::to_si_kinematic_viscosity(d.units, eddy.max);
  }
  c.wall_time = elapsed();
  c.membrane_share = s.state.membrane_seconds / c.wall_time;
  c.mlups = double(total) * cells / c.wall_time / 1e6;
  c.stretch_max = stretch.largest;
  auto assumed = assumptions(scene, d, smagorinsky);
  add_range(assumed, stretch, material);
  core::write_summary(options.out / "summary.json", {figures(c), assumed});
  if (stopped)
    throw Stopped(
        fmt::format("Stopped by a signal at t = {:.4g} s; the results until then are in {}.",
                    now.time, options.out.string()));
  return c;
}

template <class Real>
Certificate march_with(Scene const& scene, RunOptions const& options, HydrostaticScene const& start,
                       double smagorinsky)
{
  return scene.coupling.method == CouplingMethod::sharp
             ? march<Real, ibm::Sharp>(scene, options, start, smagorinsky)
             : march<Real, ibm::Diffuse>(scene, options, start, smagorinsky);
}

}  // namespace

void run_coupled(Scene const& scene, RunOptions const& options)
{
  Derived const d = derive(scene);
  HydrostaticScene start = make_membrane_scene(scene, d);
  if (start.seat) find_equilibrium(start, scene, d);
  double const smagorinsky = smagorinsky_constant(scene, start.seat != nullptr);
  for (auto const& [name, sentence] : assumptions(scene, d, smagorinsky))
    spdlog::info("{}: {}", name, sentence);
  if (start.seat)
    spdlog::info("starts from the hydrostatic state: centre {:.4f} mm below the flat membrane",
                 1e3 * core::to_si_length(
                           d.units, start.membrane.reference[0] - start.membrane.position[0]));
  Certificate const c = scene.lattice.precision == Precision::double_
                            ? march_with<double>(scene, options, start, smagorinsky)
                            : march_with<float>(scene, options, start, smagorinsky);
  spdlog::info("{}", certificate_text(c));
  spdlog::info("results: {}", (options.out / "run.xmf").string());
}

}  // namespace velum::cases
