#include <fmt/format.h>

#include <filesystem>

#include "cases/app/scene_checks.hpp"

namespace velum::cases {

bool can_be_kept(Scene const& scene)
{
  return scene.membrane && scene.coupling.method == CouplingMethod::sharp &&
         (scene.fidelity == Fidelity::axisymmetric || scene.fidelity == Fidelity::planar);
}

void check_march(Scene const& scene)
{
  std::string const what =
      "is for fluid and membrane together (fidelity \"axisymmetric\" or \"planar\", a membrane, "
      "coupling.method = \"sharp\"); no other state is kept.";
  if (scene.start && !can_be_kept(scene)) reject(scene, "start", what);
  if (scene.run.checkpoint_every && !can_be_kept(scene))
    reject(scene, "run.checkpoint_every", what);
  if (scene.run.fall_back > 0 && !can_be_kept(scene)) reject(scene, "run.fall_back", what);
  if (!scene.start || scene.start->scene.empty()) return;
  std::string const& name = scene.start->scene;
  if (name == "scene.toml")
    reject(scene, "start.scene",
           "= \"scene.toml\" is what the results folder calls the scene itself; give the other "
           "scene another name.");
  auto const file = std::filesystem::path(scene.source.file).parent_path() / name;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    reject(scene, "start.scene",
           fmt::format("= \"{}\": there is no such file beside the scene.", name));
  if (std::filesystem::equivalent(file, scene.source.file, ignored))
    reject(scene, "start.scene", "is the scene itself; leave the key out.");
}

}  // namespace velum::cases
