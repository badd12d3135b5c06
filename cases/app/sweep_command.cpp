#include "cases/app/any_scene.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/picture.hpp"
#include "cases/app/results.hpp"
#include "cases/app/stop.hpp"
#include "cases/app/sweep.hpp"
#include "core/check.hpp"
#include "core/log.hpp"
#include "core/output/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace velum::cases {
namespace {

constexpr std::size_t most_pictured = 2;  // keys

/// What one run replaces in the scene.
std::vector<std::string> overrides(Options const& options, std::vector<SweepAxis> const& axes,
                                   SweepRun const& run)
{
  auto set = options.set;
  for (std::size_t a = 0; a < axes.size(); ++a) set.push_back(axes[a].key + '=' + run.values[a]);
  return set;
}

/// The scene of one run; what is wrong with a value that the sweep gives is said of --over.
AnyScene read_swept(Options const& options, std::vector<SweepAxis> const& axes, SweepRun const& run)
{
  try {
    return read_any_scene(options.scene, overrides(options, axes, run));
  } catch (core::InputError const& error) {
    std::string const sentence = error.what(), set = "--set: ";
    if (!sentence.starts_with(set)) throw;
    std::string const rest = sentence.substr(set.size());
    std::string const key = rest.substr(0, rest.find_first_of(": "));
    for (auto const& axis : axes)  // the key itself, a table on the way to it, or what is within
      if (axis.key == key || axis.key.starts_with(key + '.') || key.starts_with(axis.key + '.'))
        throw core::InputError("--over: " + rest);
    throw;
  }
}

/// Takes over a run of this very scene that an earlier sweep has done.
void take_done(SweepRun& run, AnyScene const& scene, std::filesystem::path const& folder)
{
  std::error_code ignored;
  if (!std::filesystem::exists(folder / "summary.json", ignored) ||
      !is_of_scene(folder, source_of(scene), files_of(scene)))
    return;
  try {
    run.figures = core::read_summary(folder / "summary.json").figures;
    run.outcome = "ok";
  } catch (core::InputError const&) {
    // damaged: it is run anew
  }
}

void carry_out(SweepRun& run, AnyScene const& scene, RunOptions const& options)
{
  auto const summary = options.out / "summary.json";
  prepare_results(source_of(scene), files_of(scene), options.out);
  core::start_log(options.out, core::Console::quiet);
  try {
    run_any(scene, options);
    run.figures = core::read_summary(summary).figures;
    run.outcome = "ok";
  } catch (core::Divergence const& failure) {
    run.outcome = failure.what();
  } catch (core::InputError const& failure) {
    run.outcome = failure.what();
  } catch (Stopped const&) {
    // half a run must not pass for a whole one when the sweep goes on
    std::filesystem::remove(summary);
    throw;
  }
}

/// What is said while a sweep goes on.
struct Report {
  std::vector<SweepAxis> const& axes;
  std::vector<SweepRun> const& runs;
  Options const& options;
  std::size_t said = 0;

  void say(SweepRun const& run, std::string const& how)
  {
    ++said;
    if (options.quiet) return;
    fmt::print("{:>3}/{}  {} ({})\n", said, runs.size(),
               run_text(axes, run, shown_figures(runs, options.show)), how);
    std::fflush(stdout);
  }
};

}  // namespace

void sweep_command(Options const& options)
{
  auto const axes = read_axes(options.over);
  auto runs = sweep_runs(axes);
  std::vector<AnyScene> scenes;  // all are read first: bad input is said before anything is run
  for (auto const& run : runs) scenes.push_back(read_swept(options, axes, run));
  auto const out = core::make_folder(options.out.empty() ? std::filesystem::path("results") /
                                                               ("sweep_" + name_of(scenes.front()))
                                                         : options.out);
  auto const table = out / "sweep.csv";
  catch_stop_signals();

  for (std::size_t k = 0; k < runs.size(); ++k) take_done(runs[k], scenes[k], out / runs[k].folder);
  Report report{axes, runs, options};
  for (auto const& run : runs)
    if (!run.outcome.empty()) report.say(run, "done before");
  core::write_atomically(table, csv(axes, runs));

  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (!runs[k].outcome.empty()) continue;
    auto const start = std::chrono::steady_clock::now();
    try {
      if (stop_requested()) throw Stopped("");
      carry_out(
          runs[k], scenes[k],
          {.out = out / runs[k].folder, .quiet = true, .set = overrides(options, axes, runs[k])});
    } catch (Stopped const&) {
      throw Stopped(fmt::format(
          "Stopped by a signal after {} of {} runs; the table so far is {}, and the same "
          "command goes on.",
          report.said, runs.size(), table.string()));
    }
    core::write_atomically(table, csv(axes, runs));
    std::chrono::duration<double> const elapsed = std::chrono::steady_clock::now() - start;
    report.say(runs[k], fmt::format("{:.3g} s", elapsed.count()));
  }
  fmt::print("{}\n", table.string());
  auto const shown = shown_figures(runs, options.show);
  if (axes.size() <= most_pictured && !shown.empty()) draw("sweep.py", out, shown);
  check_shown(runs, options.show);
}

}  // namespace velum::cases
