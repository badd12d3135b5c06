#include <fmt/format.h>
#include <toml++/toml.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>

#include "cases/app/derived.hpp"
#include "cases/app/results.hpp"
#include "cases/app/settled_state.hpp"
#include "cases/app/version.hpp"

namespace velum::cases {
namespace {

/// FNV-1a of 64 bits: Fowler, Noll, Vo (RFC 9923).
std::uint64_t fnv(std::string const& text)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (char const c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

toml::table* inner(toml::table* table, std::string const& key)
{
  return table ? (*table)[key].as_table() : nullptr;
}

void put(toml::table* table, std::string const& key, double value)
{
  if (table && table->contains(key)) table->insert_or_assign(key, value);
}

/// The scene as run, with what changes over time as it is at t = 0.
toml::table held(Scene const& scene)
{
  toml::table all = toml::parse(scene.source.text);
  for (auto const& b : scene.boundaries) {
    bool const top = b.name == "inlet" || b.name == "outlet";
    auto* const table = inner(top ? &all : inner(&all, "boundary"), b.name);
    for (auto const* key : {"pressure", "velocity", "flow_rate"})
      if (!b.value.at.empty()) put(table, key, value_at(b.value, 0));
  }
  for (auto const& o : scene.orifices)
    if (o.seat)
      put(inner(inner(inner(&all, "orifice"), o.name), "seat"), "lift", value_at(o.seat->lift, 0));
  if (scene.membrane && scene.membrane->centre)
    put(inner(inner(&all, "membrane"), "centre"), "displacement",
        value_at(scene.membrane->centre->displacement, 0));
  return all;
}

std::string text_of(toml::table const& table)
{
  std::ostringstream text;
  text << table;
  return text.str();
}

/// The files that a scene reads, one after the other.
std::string contents(Scene const& scene)
{
  std::string all;
  auto const folder = std::filesystem::path(scene.source.file).parent_path();
  for (auto const& name : files_of(scene.solids, scene.materials, {})) {
    std::ifstream file(folder / name, std::ios::binary);
    all.append(std::istreambuf_iterator<char>(file), {});
  }
  return all;
}

/// Tables that a state of one scene must share with another one that begins from it.
std::string body(Scene const& scene)
{
  auto all = held(scene);
  if (auto* const centre = inner(inner(&all, "membrane"), "centre")) put(centre, "displacement", 0);
  toml::table kept;
  for (auto const* key : {"lattice", "fluid", "solid", "material", "membrane", "contact", "gap"})
    if (all.contains(key)) kept.insert(key, *all[key].node());
  return text_of(kept) + contents(scene);
}

}  // namespace

std::string state_name(Scene const& initial, double settle)
{
  auto all = held(initial);
  for (auto const* key : {"run", "start", "name", "chart"}) all.erase(key);
  std::string text =
      fmt::format("velum {}, {} s, dt {} s\n", version(), settle, derive(initial).units.dt);
  // a member's lift is read from a table up to its largest: exact at its ends alone
  for (auto const& o : initial.orifices)
    if (o.member && value_at(o.seat->lift, 0) != 0)
      text += fmt::format("{} m\n", largest_magnitude(o.seat->lift));
  return fmt::format("{:016x}", fnv(text + text_of(all) + contents(initial)));
}

Scene initial_scene(Scene const& scene, std::vector<std::string> const& overrides)
{
  if (!scene.start || scene.start->scene.empty()) return scene;
  auto const file = std::filesystem::path(scene.source.file).parent_path() / scene.start->scene;
  Scene initial = read_scene(file, overrides);
  if (initial.fidelity != scene.fidelity || body(initial) != body(scene))
    reject(scene, "start.scene",
           fmt::format("= \"{}\" is a scene of another fidelity, lattice, fluid, solid, material, "
                       "membrane, contact or gap; only what drives the two may differ.",
                       scene.start->scene));
  double const dt = derive(scene).units.dt, other = derive(initial).units.dt;
  if (dt != other)
    reject(
        scene, "start.scene",
        fmt::format("= \"{}\" has a time step of {:.6g} s and this scene one of {:.6g} s, for the "
                    "largest pressures differ; give both the same lattice.time_step.",
                    scene.start->scene, other, dt));
  return initial;
}

}  // namespace velum::cases
