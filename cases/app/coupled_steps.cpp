#include "cases/app/coupled_steps.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "cases/app/coupled_checkpoint.hpp"
#include "cases/app/coupled_watch.hpp"
#include "cases/app/fall_back.hpp"
#include "cases/app/progress.hpp"
#include "cases/app/settled_state.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"

namespace velum::cases {

namespace {

constexpr long guard_every = 200;         // steps
constexpr double checkpoint_share = 0.1;  // of the run, between two

template <class Real, template <class> class Body>
std::string coupling_in_words(ibm::Coupled<Real, Body> const& s)
{
  bool const implicit = std::holds_alternative<structure::ImplicitStepper>(s.stepper);
  return fmt::format("{} links, {}", s.body.exchange.link_count,
                     implicit ? "implicit" : fmt::format("{} sub-steps", s.substeps));
}

template <class Real, template <class> class Body>
void keep(CoupledRun<Real, Body>& run)
{
  if constexpr (keeps_state<Real, Body>) {
    double const before = std::exchange(run.march.seconds, run.seconds());
    run.kept = save_checkpoint(run.options.out, run.s, run.march, run.scene.source.text);
    run.march.seconds = before;
  }
}

/// Looks at the whole fluid; throws where it has left the range of the method.
template <class Real, template <class> class Body>
void look(CoupledRun<Real, Body>& run, CoupledWatch& watch, ProgressLine& progress, double cells)
{
  Certificate& c = run.march.certificate;
  long const n = run.march.step;
  double const time = double(n) * run.when.dt;
  lbm::Observation const seen = lbm::observe(run.s.state.fluid);
  note_look(watch, run.s, seen, n, time);
  guard(run.s, seen, n);
  c.mach_max = std::max(c.mach_max, seen.speed_max * std::numbers::sqrt3);
  c.speed_max = std::max(c.speed_max, core::to_si_velocity(run.s.derived.units, seen.speed_max));
  progress.show({.time = time,
                 .end = double(run.when.total) * run.when.dt,
                 .mlups = double(n) * cells / run.seconds() / 1e6,
                 .mach = c.mach_max,
                 .coupling = coupling_in_words(run.s.state)});
}

template <class Real, template <class> class Body>
void march_on(CoupledRun<Real, Body>& run, CoupledWatch& watch, ProgressLine& progress)
{
  auto& [scene, options, s, when, march, kept, stopped, began] = run;
  auto const cells = double(lbm::observe(s.state.fluid).cells);
  for (long n = march.step + 1; n <= when.total && !stopped; ++n) {
    march.step = n;
    take_step(s, scene, n, n > when.settle);
    note_step(watch, s, scene, n, double(n) * when.dt);
    add_flows(march.flows, s);
    bool const looks = n % guard_every == 0 || n == when.total;
    if (looks) look(run, watch, progress, cells);
    if (n % when.sample == 0 || n == when.settle || n == when.window)
      take_stock(march, s, scene, when);
    if (!looks) continue;
    stopped = stop_requested();
    double const time = double(n) * when.dt;
    if (time < march.next_checkpoint && !stopped && n < when.total) continue;
    while (march.next_checkpoint <= time) march.next_checkpoint += checkpoint_every(scene);
    keep(run);  // before what follows: a longer run would not have stopped here
  }
  if (march.measured != march.step) take_stock(march, s, scene, when);
}

}  // namespace

double checkpoint_every(Scene const& scene)
{
  return scene.run.checkpoint_every.value_or(checkpoint_share * scene.run.end);
}

template <class Real>
void resume(CoupledRun<Real, ibm::Sharp>& run, core::Assumptions const& said)
{
  auto file = core::StateFile::open(run.options.restart);
  std::string text = run.scene.source.text;
  exchange(file, run.s, run.march, text);
  if (text != run.scene.source.text)
    spdlog::info(
        "the scene is not the one that wrote the checkpoint; it goes on as the scene is now");
  run.kept = run.options.restart;
  run.march.out =
      resume_output(std::move(run.march.out), run.scene, run.s.derived, said, run.options.out);
  spdlog::info("goes on from {} at t = {:.4g} s", run.options.restart.string(),
               double(run.march.step) * run.when.dt);
}

template <class Real>
void fall_back(CoupledRun<Real, ibm::Sharp>& run, Scene const& asked, Scene const& initial,
               HydrostaticScene& start, double smagorinsky, core::Assumptions const& said)
{
  long const before = times_fallen(run.kept), now = run.march.fallen + 1;
  double const seconds = run.march.seconds;
  start = make_start(slower(initial, before));
  auto old = make_coupled_scene<Real, ibm::Sharp>(slower(asked, before), start, smagorinsky);
  auto file = core::StateFile::open(run.kept);
  std::string text;
  exchange(file, old, run.march, text);
  double const time = double(run.march.step) * old.derived.units.dt;
  bool const measured = run.march.measured == run.march.step;

  run.scene = slower(asked, now);
  start = make_start(slower(initial, now));
  run.s = make_coupled_scene<Real, ibm::Sharp>(run.scene, start, smagorinsky);
  carry_over(old, run.s, run.march.flows);
  run.when = calendar(run.scene.run, run.s.derived.units.dt);
  run.march.step = std::lround(time / run.when.dt);
  run.march.measured = measured ? run.march.step : run.march.step - 1;
  run.march.fallen = now;
  run.march.seconds = seconds;
  run.march.out =
      resume_output(std::move(run.march.out), run.scene, run.s.derived, said, run.options.out);
  spdlog::warn("falls back to t = {:.4g} s and goes on with a time step of {:.4g} s, Mach {:.3g}",
               time, run.when.dt, run.s.derived.mach);
}

template <class Real, template <class> class Body>
void take_steps(CoupledRun<Real, Body>& run)
{
  auto watch = make_watch(run.s, run.scene);
  ProgressLine progress(run.options.quiet);
  try {
    march_on(run, watch, progress);
    progress.finish();
  } catch (core::Divergence const& failure) {
    progress.finish();
    if (long const n = run.march.step; watch.steps.rows.empty() || watch.steps.rows.back().step < n)
      note_step(watch, run.s, run.scene, n, double(n) * run.when.dt);
    std::string text = failure.what();
    if (auto const causes = open_black_box(watch, run.options.out); !causes.empty())
      text += " " + causes;
    text += fmt::format(" What led to it is in {}.", (run.options.out / "blackbox.csv").string());
    if (!run.kept.empty()) text += fmt::format(" The last good state is in {}.", run.kept.string());
    throw core::Divergence(text);
  }
}

template void take_steps(CoupledRun<float, ibm::Sharp>&);
template void take_steps(CoupledRun<float, ibm::Diffuse>&);
template void take_steps(CoupledRun<double, ibm::Sharp>&);
template void take_steps(CoupledRun<double, ibm::Diffuse>&);
template void resume(CoupledRun<float, ibm::Sharp>&, core::Assumptions const&);
template void resume(CoupledRun<double, ibm::Sharp>&, core::Assumptions const&);
template void fall_back(CoupledRun<float, ibm::Sharp>&, Scene const&, Scene const&,
                        HydrostaticScene&, double, core::Assumptions const&);
template void fall_back(CoupledRun<double, ibm::Sharp>&, Scene const&, Scene const&,
                        HydrostaticScene&, double, core::Assumptions const&);

}  // namespace velum::cases
