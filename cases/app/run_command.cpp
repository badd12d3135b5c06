#include "cases/app/body_run.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/results.hpp"
#include "cases/app/scene.hpp"
#include "cases/app/simulation.hpp"
#include "cases/app/stop.hpp"
#include "core/log.hpp"

namespace velum::cases {

namespace {

/// What a paper or a measurement says, beside a scene, for velum plot to mark.
constexpr char const* paper_values = "paper.csv";

/// Makes the results folder of a Scene or a BodyScene ready and starts the log in it.
/// @param mesh  name of the file that the body is from; empty: none
template <class AnyScene>
std::filesystem::path begin(Options const& options, AnyScene const& scene, std::string const& mesh)
{
  auto const out = std::filesystem::absolute(
      options.out.empty() ? std::filesystem::path("results") / scene.name : options.out);
  prepare_results(
      scene.source,
      files_of(scene.solids, scene.materials,
               {mesh, scene.reference ? scene.reference->file : std::string(), paper_values}),
      out);
  core::start_log(out, options.quiet ? core::Console::quiet : core::Console::normal);
  catch_stop_signals();
  return out;
}

}  // namespace

void run_command(Options const& options)
{
  if (is_body_scene(options.scene, options.set)) {
    auto const scene = read_body_scene(options.scene, options.set);
    return run_body(scene, begin(options, scene, scene.body.file));
  }
  Scene const scene = read_scene(options.scene, options.set);
  run(scene, {.out = begin(options, scene, ""), .quiet = options.quiet});
}

}  // namespace velum::cases
