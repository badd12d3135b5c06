#include "cases/app/any_scene.hpp"

#include "cases/app/body_run.hpp"
#include "cases/app/results.hpp"

namespace velum::cases {
namespace {

/// What a paper or a measurement says, beside a scene, for velum plot to mark.
constexpr char const* paper_values = "paper.csv";

/// Name of the file that a scene is from besides those of its solids and materials: another scene,
/// a mesh; empty: none.
std::string other_file(Scene const& scene) { return scene.start ? scene.start->scene : ""; }
std::string other_file(BodyScene const& scene) { return scene.body.file; }

}  // namespace

AnyScene read_any_scene(std::filesystem::path const& file,
                        std::vector<std::string> const& overrides)
{
  if (is_body_scene(file, overrides)) return read_body_scene(file, overrides);
  return read_scene(file, overrides);
}

std::string const& name_of(AnyScene const& scene)
{
  return std::visit([](auto const& s) -> std::string const& { return s.name; }, scene);
}

SceneFile const& source_of(AnyScene const& scene)
{
  return std::visit([](auto const& s) -> SceneFile const& { return s.source; }, scene);
}

std::vector<std::string> files_of(AnyScene const& scene)
{
  return std::visit(
      [](auto const& s) {
        return files_of(
            s.solids, s.materials,
            {other_file(s), s.reference ? s.reference->file : std::string(), paper_values});
      },
      scene);
}

void run_any(AnyScene const& scene, RunOptions const& options)
{
  if (auto const* body = std::get_if<BodyScene>(&scene)) return run_body(*body, options.out);
  run(std::get<Scene>(scene), options);
}

}  // namespace velum::cases
