#pragma once
#include "cases/app/scene.hpp"
#include "cases/app/scene_table.hpp"

namespace velum::cases {

/// A scene file while it is read, what it is based on and the overrides merged in.
class OpenScene {
 public:
  /// @throws core::InputError  no such file, not TOML, or an override that does not fit
  OpenScene(std::filesystem::path const& file, std::vector<std::string> const& overrides);

  SceneTable root() { return {merged_, "", origins_}; }
  /// Where the scene came from, once all of it is read.
  SceneFile close();

 private:
  toml::table merged_;
  Origins origins_;
};

}  // namespace velum::cases
