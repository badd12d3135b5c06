#include "cases/app/results.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace velum::cases {
namespace {

constexpr std::array files_of_run = {
    "run.h5",          "run.xmf",         "series.csv",   "summary.json",       "log.txt",
    "checkpoint_a.h5", "checkpoint_b.h5", "blackbox.csv", "blackbox_steps.csv", "kv.csv"};

/// Brings what a run goes on with into another folder.
void take_over(std::filesystem::path const& from, std::filesystem::path const& out)
{
  std::error_code error;
  if (std::filesystem::equivalent(from, out, error)) return;
  for (auto const* name : files_of_run) std::filesystem::remove(out / name, error);
  for (auto const* name : {"run.h5", "run.xmf", "series.csv"}) {
    if (!std::filesystem::exists(from / name, error)) continue;
    std::filesystem::copy_file(from / name, out / name, error);
    if (error)
      throw core::InputError(fmt::format("--out: {} cannot be copied to {}: {}.",
                                         (from / name).string(), out.string(), error.message()));
  }
}

/// The whole text of a file; empty where there is none.
std::string text_of(std::filesystem::path const& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

void prepare_results(SceneFile const& source, std::vector<std::string> const& files,
                     std::filesystem::path const& out, std::filesystem::path const& restart)
{
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (!std::filesystem::is_directory(out))
    throw core::InputError(
        fmt::format("--out: the results folder {} cannot be made: {}.", out.string(),
                    error ? error.message() : "a file of that name is in the way"));

  auto const scene_file = out / "scene.toml";
  std::error_code ignored;
  if (restart.empty() && std::filesystem::equivalent(scene_file, source.file, ignored))
    throw core::InputError(fmt::format(
        "--out: the results folder {} holds the scene file itself, which the run would overwrite; "
        "choose another folder.",
        out.string()));
  if (!restart.empty())
    take_over(restart.parent_path(), out);
  else
    for (auto const* name : files_of_run) std::filesystem::remove(out / name, ignored);

  // With the files that it names beside it, the scene as run can be run again from there.
  auto const folder = std::filesystem::path(source.file).parent_path();
  for (auto const& name : files)
    std::filesystem::copy_file(folder / name, out / name,
                               std::filesystem::copy_options::overwrite_existing, ignored);

  std::ofstream file(scene_file);
  file << source.text << std::flush;
  if (!file)
    throw core::InputError(fmt::format("--out: the results folder {} cannot be written: {}.",
                                       out.string(), std::generic_category().message(errno)));
}

bool is_of_scene(std::filesystem::path const& out, SceneFile const& source,
                 std::vector<std::string> const& files)
{
  auto const folder = std::filesystem::path(source.file).parent_path();
  return text_of(out / "scene.toml") == source.text &&
         std::all_of(files.begin(), files.end(), [&](std::string const& name) {
           return text_of(out / name) == text_of(folder / name);
         });
}

std::vector<std::string> files_of(std::vector<Solid> const& solids,
                                  std::map<std::string, Material> const& materials,
                                  std::vector<std::string> others)
{
  for (auto const& solid : solids) others.push_back(solid.file);
  for (auto const& [name, material] : materials) others.push_back(material.file);
  std::erase(others, "");
  return others;
}

}  // namespace velum::cases
