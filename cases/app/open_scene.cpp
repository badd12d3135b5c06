#include "cases/app/open_scene.hpp"

#include "cases/app/overrides.hpp"
#include "cases/app/scene_base.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

namespace velum::cases {

OpenScene::OpenScene(std::filesystem::path const& file, std::vector<std::string> const& overrides)
{
  std::error_code ignored;
  core::require(!std::filesystem::is_directory(file, ignored),
                fmt::format("{}: is not a file; name the scene.toml in it.", file.string()));
  merged_ = read_tables(file);
  origins_.file = file.string();
  for (auto const& text : overrides) origins_.overridden.push_back(apply_override(merged_, text));
}

SceneFile OpenScene::close()
{
  std::ostringstream text;
  text << merged_ << '\n';
  return {text.str(), origins_.file, std::move(origins_.places)};
}

}  // namespace velum::cases
