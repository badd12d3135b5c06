#include "cases/app/body_run.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/results.hpp"
#include "cases/app/scene.hpp"
#include "cases/app/simulation.hpp"
#include "cases/app/stop.hpp"
#include "core/log.hpp"

namespace velum::cases {

namespace {

/// Makes the results folder ready and starts the log in it.
std::filesystem::path begin(Options const& options, std::string const& name,
                            SceneFile const& source, std::vector<std::string> const& files)
{
  auto const out = std::filesystem::absolute(
      options.out.empty() ? std::filesystem::path("results") / name : options.out);
  prepare_results(source, files, out);
  core::start_log(out, options.quiet ? core::Console::quiet : core::Console::normal);
  catch_stop_signals();
  return out;
}

}  // namespace

void run_command(Options const& options)
{
  if (is_body_scene(options.scene, options.set)) {
    auto const scene = read_body_scene(options.scene, options.set);
    return run_body(scene, begin(options, scene.name, scene.source, files_of(scene)));
  }
  Scene const scene = read_scene(options.scene, options.set);
  run(scene,
      {.out = begin(options, scene.name, scene.source, files_of(scene)), .quiet = options.quiet});
}

}  // namespace velum::cases
