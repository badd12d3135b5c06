#include "cases/app/commands.hpp"
#include "cases/app/results.hpp"
#include "cases/app/scene.hpp"
#include "cases/app/simulation.hpp"
#include "cases/app/stop.hpp"
#include "core/log.hpp"

namespace velum::cases {

void run_command(Options const& options)
{
  Scene const scene = read_scene(options.scene, options.set);
  auto const out = std::filesystem::absolute(
      options.out.empty() ? std::filesystem::path("results") / scene.name : options.out);
  prepare_results(scene, out);
  core::start_log(out, options.quiet ? core::Console::quiet : core::Console::normal);
  catch_stop_signals();
  run(scene, {.out = out, .quiet = options.quiet});
}

}  // namespace velum::cases
