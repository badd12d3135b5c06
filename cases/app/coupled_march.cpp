#include "cases/app/coupled_march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check.hpp"

namespace velum::cases {
namespace {

constexpr int samples_per_run = 400;  // rows of series.csv at least
constexpr double window_share = 0.5;  // of the settling stage: over which leaks are averaged

double jump(Measurement const& m)
{
  return std::min(m.pressure_above, m.pressure_outside) - m.pressure_inside;
}

}  // namespace

Calendar calendar(Schedule const& run, double dt)
{
  Calendar c{.dt = dt,
             .settle = std::lround(run.settle / dt),
             .total = std::lround(run.end / dt),
             .window = 0,
             .sample = 0};
  c.window = std::lround(double(c.settle) * (1 - window_share));
  c.sample =
      std::clamp(std::lround(run.sample_every / dt), 1L, std::max(1L, c.total / samples_per_run));
  return c;
}

template <class Real, template <class> class Body>
void take_stock(March& march, CoupledScene<Real, Body> const& s, Scene const& scene,
                Calendar const& when)
{
  Certificate& c = march.certificate;
  march.now = measure(s, scene, march.flows, double(march.step) * when.dt);
  march.measured = march.step;
  record(march.out, s, march.now, scene.run.output_every);
  note_stretch(march.stretch, s.state.membrane, scene);
  if (march.step == 0) {
    if (!s.driven.empty()) c.driven = start_record(march.now);
    c.window_begin = c.settled = march.now;
    return;
  }
  if (c.driven) note(*c.driven, march.now);
  if (march.step <= when.window) c.window_begin = march.now;
  if (march.step <= when.settle) c.settled = march.now;
  if (march.step > when.settle) c.least_jump_shut = std::min(c.least_jump_shut, jump(march.now));
  c.penetration_max = std::max(c.penetration_max, march.now.penetration);
}

template <class Real, template <class> class Body>
void take_step(CoupledScene<Real, Body>& s, Scene const& scene, long n, bool shut, bool held)
{
  double const time = held ? 0 : double(n) * s.derived.units.dt;
  set_targets(s, scene, time, shut);
  drive(s, scene, time);
  try {
    ibm::step(s.state);
  } catch (core::Divergence const& failure) {
    throw core::Divergence(
        fmt::format("Diverged at step {} (t = {:.4g} s), body membrane: {}. Likely cause: {}.", n,
                    core::to_si_time(s.derived.units, double(n)), failure.what(), likely_cause(s)));
  }
}

template void take_stock(March&, CoupledScene<float, ibm::Sharp> const&, Scene const&,
                         Calendar const&);
template void take_step(CoupledScene<float, ibm::Sharp>&, Scene const&, long, bool, bool);
template void take_stock(March&, CoupledScene<float, ibm::Diffuse> const&, Scene const&,
                         Calendar const&);
template void take_step(CoupledScene<float, ibm::Diffuse>&, Scene const&, long, bool, bool);
template void take_stock(March&, CoupledScene<double, ibm::Sharp> const&, Scene const&,
                         Calendar const&);
template void take_step(CoupledScene<double, ibm::Sharp>&, Scene const&, long, bool, bool);
template void take_stock(March&, CoupledScene<double, ibm::Diffuse> const&, Scene const&,
                         Calendar const&);
template void take_step(CoupledScene<double, ibm::Diffuse>&, Scene const&, long, bool, bool);

}  // namespace velum::cases
