#include "cases/app/settled_state.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "cases/app/coupled_march.hpp"
#include "cases/app/fluid_guard.hpp"
#include "cases/app/progress.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/output/folder.hpp"

namespace velum::cases {
namespace {

/// Marches without a row, the drivers held.
template <class Real>
void settle(CoupledScene<Real, ibm::Sharp>& s, Scene const& initial, double duration, bool quiet)
{
  double const dt = s.derived.units.dt;
  long const steps = std::max(1L, std::lround(duration / dt));
  auto const cells = double(lbm::observe(s.state.fluid).cells);
  auto const begin = std::chrono::steady_clock::now();
  ProgressLine progress(quiet);
  double mach = 0;
  for (long n = 1; n <= steps; ++n) {
    take_step(s, initial, n, false, true);
    if (n % guard_every != 0 && n != steps) continue;
    auto const seen = lbm::observe(s.state.fluid);
    guard(s, seen, n);
    mach = std::max(mach, seen.speed_max * std::numbers::sqrt3);
    std::chrono::duration<double> const elapsed = std::chrono::steady_clock::now() - begin;
    progress.show({.time = double(n) * dt,
                   .end = double(steps) * dt,
                   .mlups = double(n) * cells / elapsed.count() / 1e6,
                   .mach = mach,
                   .coupling = "settling"});
    if (stop_requested() && n < steps) {
      progress.finish();
      throw Stopped(fmt::format(
          "Stopped by a signal {:.4g} s into settling; nothing is kept of it.", double(n) * dt));
    }
  }
  progress.finish();
}

template <class Real>
void exchange_settled(core::StateFile file, CoupledScene<Real, ibm::Sharp>& s)
{
  Flows none;
  restart_sums(s, none);
  exchange_state(file, s, none);
  if (file.reading())
    restart_sums(s, none);
  else
    file.commit();
}

}  // namespace

HydrostaticScene make_start(Scene const& initial)
{
  Derived const d = derive(initial);
  HydrostaticScene start = make_membrane_scene(initial, d);
  if (start.seat) find_equilibrium(start, initial, d);
  return start;
}

template <class Real>
CoupledScene<Real, ibm::Sharp> make_settled_scene(Scene const& scene, Scene const& initial,
                                                  HydrostaticScene& start, double smagorinsky,
                                                  RunOptions const& options)
{
  std::string const name = state_name(initial, scene.start->settle);
  auto const file = core::make_folder(options.out.parent_path() / "states") / (name + ".h5");
  std::error_code ignored;
  auto const loaded = [&] {
    auto s = make_coupled_scene<Real, ibm::Sharp>(scene, start, smagorinsky);
    exchange_settled(core::StateFile::open(file), s);
    return s;
  };
  if (std::filesystem::exists(file, ignored)) try {
      auto s = loaded();
      spdlog::info("starts from the settled state {}, computed before", name);
      return s;
    } catch (core::InputError const& damaged) {
      spdlog::warn("{} It is computed anew.", damaged.what());
      start = make_start(initial);  // the seat is shared with what was read
    }
  spdlog::info("settling for {:.4g} ms with all that drives the scene as it is at t = 0",
               1e3 * scene.start->settle);
  {
    auto s = make_coupled_scene<Real, ibm::Sharp>(initial, start, smagorinsky);
    settle(s, initial, scene.start->settle, options.quiet);
    exchange_settled(core::StateFile::create(file), s);
  }
  spdlog::info("starts from the settled state {}, kept in {}", name, file.string());
  start = make_start(initial);
  return loaded();  // as any later run will: the same to the last bit
}

template CoupledScene<float, ibm::Sharp> make_settled_scene(Scene const&, Scene const&,
                                                            HydrostaticScene&, double,
                                                            RunOptions const&);
template CoupledScene<double, ibm::Sharp> make_settled_scene(Scene const&, Scene const&,
                                                             HydrostaticScene&, double,
                                                             RunOptions const&);

}  // namespace velum::cases
