#include "cases/app/body_run.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/results.hpp"
#include "cases/app/scene_checks.hpp"
#include "cases/app/simulation.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/log.hpp"

namespace velum::cases {

namespace {

/// What a paper or a measurement says, beside a scene, for velum plot to mark.
constexpr char const* paper_values = "paper.csv";

/// Makes the results folder of a Scene or a BodyScene ready and starts the log in it.
/// @param other  name of a file beside it that it is from: a mesh, another scene; empty: none
template <class AnyScene>
std::filesystem::path begin(Options const& options, AnyScene const& scene, std::string const& other)
{
  auto const otherwise = options.restart.empty() ? std::filesystem::path("results") / scene.name
                                                 : options.restart.parent_path();
  auto const out = std::filesystem::absolute(options.out.empty() ? otherwise : options.out);
  prepare_results(
      scene.source,
      files_of(scene.solids, scene.materials,
               {other, scene.reference ? scene.reference->file : std::string(), paper_values}),
      out, options.restart);
  core::start_log(out, options.quiet ? core::Console::quiet : core::Console::normal,
                  !options.restart.empty());
  catch_stop_signals();
  return out;
}

void check_restart(std::filesystem::path const& file, bool coupled)
{
  core::require(coupled,
                "--restart is for fluid and membrane together with coupling.method = \"sharp\"; no "
                "other run writes checkpoints.");
  std::error_code ignored;
  core::require(std::filesystem::is_regular_file(file, ignored),
                "--restart: there is no such file as " + file.string() + ".");
}

}  // namespace

void run_command(Options const& command_line)
{
  Options options = command_line;
  if (!options.restart.empty()) options.restart = std::filesystem::absolute(options.restart);
  if (is_body_scene(options.scene, options.set)) {
    auto const scene = read_body_scene(options.scene, options.set);
    if (!options.restart.empty()) check_restart(options.restart, false);
    return run_body(scene, begin(options, scene, scene.body.file));
  }
  Scene const scene = read_scene(options.scene, options.set);
  if (!options.restart.empty()) check_restart(options.restart, can_be_kept(scene));
  run(scene, {.out = begin(options, scene, scene.start ? scene.start->scene : ""),
              .quiet = options.quiet,
              .restart = options.restart,
              .set = options.set});
}

}  // namespace velum::cases
