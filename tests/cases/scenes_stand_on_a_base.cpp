// problem:   a scene that names another one as its base; a base of a base; bad bases
// reference: the same scene written out in full
// measure:   the scene as read and as stored; the sentence of a refusal, with file and line
// tolerance: none
// why:       a logical statement
#include "cases/app/body_scene.hpp"
#include "cases/app/scene.hpp"
#include "tests/cases/scene_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace velum::tests {
namespace {

struct Files {
  TemporaryFolder folder;
  Files() { write("small.toml", small_valve); }
  void write(std::string const& name, std::string const& text) const
  {
    std::ofstream(folder.path / name) << text;
  }
  cases::Scene read(std::string const& name, std::vector<std::string> const& set = {}) const
  {
    return cases::read_scene(folder.path / name, set);
  }
  /// The refusal of a scene, without the folder.
  std::string refused(std::string const& name) const
  {
    try {
      read(name);
    } catch (core::InputError const& error) {
      std::string text = error.what();
      auto const prefix = folder.path.string() + '/';
      for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
        text.erase(at, prefix.size());
      return text;
    }
    return "";
  }
};

TEST(Base, is_taken_over_but_for_what_the_scene_says)
{
  Files const files;
  files.write("own.toml", "base = \"small.toml\"\n[inlet]\npressure = \"70 kPa\"\n");
  auto const scene = files.read("own.toml");
  auto const full =
      read_text(edited(small_valve, "pressure = \"50 kPa\"", "pressure = \"70 kPa\""));
  EXPECT_EQ(scene.source.text, full.source.text);
  EXPECT_EQ(files.read("own.toml", {"inlet.pressure=50 kPa"}).source.text,
            files.read("small.toml").source.text);
}

TEST(Base, may_have_a_base)
{
  Files const files;
  files.write("middle.toml",
              "base = \"small.toml\"\nname = \"middle\"\n[run]\nsettle = \"3 ms\"\n");
  files.write("own.toml", "base = \"middle.toml\"\n[run]\noutput_every = \"1 ms\"\n");
  auto const scene = files.read("own.toml");
  EXPECT_EQ(scene.name, "middle");
  EXPECT_DOUBLE_EQ(scene.run.settle, 3e-3);
  EXPECT_DOUBLE_EQ(scene.run.output_every, 1e-3);
}

TEST(Base, keeps_file_and_line_of_what_is_wrong)
{
  Files const files;
  files.write("own.toml", "base = \"small.toml\"\n[lattice]\ndxx = \"1 um\"\n");
  EXPECT_TRUE(files.refused("own.toml").starts_with("own.toml:3: lattice.dxx is not a key"));
  files.write("bad.toml", edited(small_valve, "dx = \"100 um\"", "dx = 100"));
  files.write("own.toml", "base = \"bad.toml\"\nname = \"own\"\n");
  EXPECT_TRUE(files.refused("own.toml").starts_with("bad.toml:4: lattice.dx must be a length"));
}

TEST(Base, of_a_body_alone_is_one_too)
{
  Files const files;
  files.write("own.toml", "base = \"body.toml\"\nname = \"own\"\n");
  files.write("body.toml", "fidelity = \"structure\"\n");
  EXPECT_TRUE(cases::is_body_scene(files.folder.path / "own.toml", {}));
}

TEST(Base, that_is_none_is_refused)
{
  Files const files;
  files.write("own.toml", "base = \"smal.toml\"\n");
  EXPECT_EQ(files.refused("own.toml"),
            "own.toml:1: base = \"smal.toml\": there is no such scene file beside this one.");
  files.write("own.toml", "base = 3\n");
  EXPECT_EQ(files.refused("own.toml"),
            "own.toml:1: base must be the name of a scene file in quotes, but is the number 3.");
  files.write("other.toml", "base = \"own.toml\"\n");
  files.write("own.toml", "base = \"other.toml\"\n");
  EXPECT_EQ(files.refused("own.toml"),
            "other.toml:1: base = \"own.toml\" is this scene itself or built on it.");
}

}  // namespace
}  // namespace velum::tests
