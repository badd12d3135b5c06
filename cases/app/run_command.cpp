#include "cases/app/any_scene.hpp"
#include "cases/app/commands.hpp"
#include "cases/app/results.hpp"
#include "cases/app/scene_checks.hpp"
#include "cases/app/stop.hpp"
#include "core/check.hpp"
#include "core/log.hpp"

namespace velum::cases {
namespace {

void check_restart(std::filesystem::path const& file, AnyScene const& scene)
{
  auto const* coupled = std::get_if<Scene>(&scene);
  core::require(coupled && can_be_kept(*coupled),
                "--restart is for fluid and membrane together with coupling.method = \"sharp\"; no "
                "other run writes checkpoints.");
  std::error_code ignored;
  core::require(std::filesystem::is_regular_file(file, ignored),
                "--restart: there is no such file as " + file.string() + ".");
}

}  // namespace

void run_command(Options const& options)
{
  auto const scene = read_any_scene(options.scene, options.set);
  auto restart = options.restart;
  auto otherwise = std::filesystem::path("results") / name_of(scene);
  if (!restart.empty()) {
    restart = std::filesystem::absolute(restart);
    check_restart(restart, scene);
    otherwise = restart.parent_path();
  }
  auto const out = std::filesystem::absolute(options.out.empty() ? otherwise : options.out);
  prepare_results(source_of(scene), files_of(scene), out, restart);
  core::start_log(out, options.quiet ? core::Console::quiet : core::Console::normal,
                  !restart.empty());
  catch_stop_signals();
  run_any(scene, {.out = out, .quiet = options.quiet, .restart = restart, .set = options.set});
}

}  // namespace velum::cases
