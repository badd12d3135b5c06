#include "cases/app/coupled_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>

#include "cases/app/assumptions.hpp"
#include "cases/app/coupled_checkpoint.hpp"
#include "cases/app/coupled_steps.hpp"
#include "cases/app/fall_back.hpp"
#include "cases/app/free_oscillation.hpp"
#include "cases/app/reference.hpp"
#include "cases/app/settled_state.hpp"
#include "cases/app/stop.hpp"
#include "cases/app/valve_report.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "structure/static_solve.hpp"
#include "structure/volume_control.hpp"

namespace velum::cases {

namespace {

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

/// What the certificate knows before the first step.
void begin(Certificate& c, Scene const& scene, HydrostaticScene const& start, Derived const& d,
           Calendar const& when)
{
  c.inlet = inlet_pressure(scene, scene.run.settle);
  c.outlet = outlet_pressure(scene, scene.run.settle);
  c.centre_start = core::to_si_length(
      d.units, start.membrane.reference[2 * structure::middle_node(start.membrane)]);
  c.centre_hydrostatic = core::to_si_length(
      d.units, start.membrane.position[2 * structure::middle_node(start.membrane)]);
  c.has_shut = when.total > when.settle;
  c.least_jump_shut = c.inlet - c.outlet;
}

/// What a designer reads off the run of a valve with its orifices, of its whole history.
template <class Real, template <class> class Body>
ValveReport report(CoupledRun<Real, Body> const& run)
{
  double const seat = run.s.divide;  // cells; infinite without one
  return valve_report(
      run.scene, read_history(run.options.out / "series.csv"),
      {std::isfinite(seat) ? 2 * seat * run.s.derived.units.dx : 0, run.march.stretch});
}

/// Completes the certificate, writes summary.json, and returns what is to be printed.
template <class Real, template <class> class Body>
std::string conclude(CoupledRun<Real, Body>& run, HydrostaticScene const& start,
                     core::Assumptions said, bool eddies)
{
  Certificate& c = run.march.certificate;
  auto const& s = run.s;
  auto const& units = s.derived.units;
  c.shut = run.march.now;
  if (c.driven) c.driven->static_shape = against_rest(s, start);
  if (eddies) {
    auto const eddy = lbm::eddy_viscosity(s.state.fluid);
    c.eddy_mean = core::to_si_kinematic_viscosity(units, eddy.mean);
    c.eddy_max = core::to_si_kinematic_viscosity(units, eddy.max);
  }
  c.wall_time = run.seconds();
  c.membrane_share = s.state.membrane_seconds / c.wall_time;
  c.mlups = double(run.march.step) * double(lbm::observe(s.state.fluid).cells) / c.wall_time / 1e6;
  c.stretch_max = run.march.stretch.largest;
  add_range(said, run.march.stretch, run.scene.materials.at(run.scene.membrane->material));
  core::Summary summary{figures(c), said};
  summary.figures.push_back({"steps", double(run.march.step), "1"});
  if (run.march.stretch.face > 0)
    summary.figures.push_back({"stretch_max_face", run.march.stretch.face, "1"});
  if (!run.scene.contact && !c.driven)
    for (auto const& f : free_oscillation(read_history(run.options.out / "series.csv")))
      summary.figures.push_back(f);
  std::string text = certificate_text(c);
  if (!run.scene.orifices.empty()) {
    auto const valve = report(run);
    summary.figures.insert(summary.figures.end(), valve.figures.begin(), valve.figures.end());
    summary.assumptions.insert(valve.rules.begin(), valve.rules.end());
    if (!valve.kv.empty()) core::write_atomically(run.options.out / "kv.csv", valve.kv);
    text =
        valve.text + fmt::format("wall time {:.1f} s, {:.0f} MLUPS, {:.1f} % of it the membrane's",
                                 c.wall_time, c.mlups, 100 * c.membrane_share);
  }
  if (!run.stopped) compare_figure(run.scene, summary);
  core::write_summary(run.options.out / "summary.json", summary);
  return text;
}

template <class Real, template <class> class Body>
std::string march(Scene const& asked, Scene const& initial, RunOptions const& options,
                  HydrostaticScene& start, double smagorinsky, long fallen)
{
  Scene const scene = slower(asked, fallen);
  auto s = [&] {
    if constexpr (keeps_state<Real, Body>)
      if (scene.start && options.restart.empty())
        return make_settled_scene<Real>(scene, initial, start, smagorinsky, options);
    return make_coupled_scene<Real, Body>(scene, start, smagorinsky);
  }();
  CoupledRun<Real, Body> run{scene, options, s, calendar(scene.run, s.derived.units.dt)};
  auto const said = assumptions(scene, s.derived, smagorinsky);
  begin(run.march.certificate, scene, start, s.derived, run.when);
  if constexpr (keeps_state<Real, Body>) {
    spdlog::info("checkpoints: every {:.4g} ms, in checkpoint_a.h5 and checkpoint_b.h5 in turn",
                 1e3 * checkpoint_every(scene));
    if (!options.restart.empty()) resume(run, said);
  } else {
    spdlog::info("checkpoints: none, a diffuse membrane's state is not kept");
  }
  if (options.restart.empty()) {
    run.march.next_checkpoint = checkpoint_every(scene);
    run.march.out = start_output(scene, s.derived, said, options.out);
    take_stock(run.march, s, scene, run.when);
  }
  for (bool done = false; !done;) try {
      take_steps(run);
      done = true;
    } catch (core::Divergence const& failure) {
      if (run.march.fallen >= scene.run.fall_back || run.kept.empty()) throw;
      spdlog::warn("{}", failure.what());
      if constexpr (keeps_state<Real, Body>)
        fall_back(run, asked, initial, start, smagorinsky, said);
    }
  std::string const text = conclude(run, start, said, smagorinsky > 0);
  if (!run.stopped) return text;
  std::string const more =
      run.kept.empty() ? "" : fmt::format("; go on with --restart {}", run.kept.string());
  throw Stopped(
      fmt::format("Stopped by a signal at t = {:.4g} s; the results until then are in {}{}.",
                  run.march.now.time, options.out.string(), more));
}

template <class Real>
std::string march_with(Scene const& asked, Scene const& initial, RunOptions const& options,
                       HydrostaticScene& start, double smagorinsky, long fallen)
{
  return asked.coupling.method == CouplingMethod::sharp
             ? march<Real, ibm::Sharp>(asked, initial, options, start, smagorinsky, fallen)
             : march<Real, ibm::Diffuse>(asked, initial, options, start, smagorinsky, fallen);
}

}  // namespace

void run_coupled(Scene const& asked, RunOptions const& options)
{
  // a checkpoint may be of a run that had fallen back to a shorter step
  long const fallen = options.restart.empty() ? 0 : times_fallen(options.restart);
  Scene const scene = slower(asked, fallen), initial = initial_scene(asked, options.set);
  Derived const d = derive(scene);
  HydrostaticScene start = make_start(slower(initial, fallen));
  double const smagorinsky = smagorinsky_constant(scene, start.seat != nullptr);
  for (auto const& [name, sentence] : assumptions(scene, d, smagorinsky))
    spdlog::info("{}: {}", name, sentence);
  if (start.seat)
    spdlog::info(
        "starts from the hydrostatic state: centre {:.4f} mm below the flat membrane",
        1e3 *
            core::to_si_length(
                d.units, start.membrane.reference[2 * structure::middle_node(start.membrane)] -
                             start.membrane.position[2 * structure::middle_node(start.membrane)]));
  std::string const text =
      scene.lattice.precision == Precision::double_
          ? march_with<double>(asked, initial, options, start, smagorinsky, fallen)
          : march_with<float>(asked, initial, options, start, smagorinsky, fallen);
  spdlog::info("{}", text);
  spdlog::info("results: {}", (options.out / "run.xmf").string());
}

}  // namespace velum::cases
