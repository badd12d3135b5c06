#include "cases/app/scene_base.hpp"

#include "cases/app/scene_text.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace velum::cases {
namespace {

/// Puts a table over another. Nodes are moved: a copy would forget where it was read.
void put_over(toml::table& under, toml::table&& over)
{
  for (auto&& [key, node] : over) {
    auto* const below = under.get_as<toml::table>(key.str());
    if (below && node.is_table())
      put_over(*below, std::move(*node.as_table()));
    else
      node.visit([&](auto& typed) { under.insert_or_assign(key.str(), std::move(typed)); });
  }
}

/// @param from  the file and those that it is a base of
toml::table read(std::filesystem::path const& file, std::vector<std::filesystem::path> from)
{
  auto own = parse_toml(file, "scene file");
  auto const* base = own.get("base");
  if (!base) return own;
  auto const place = fmt::format("{}:{}: base", file.string(), base->source().begin.line);
  auto const name = base->value_exact<std::string>();
  core::require(name && !name->empty(),
                fmt::format("{} must be the name of a scene file in quotes, but is {}.", place,
                            describe(*base)));
  auto const below = file.parent_path() / *name;
  std::error_code ignored;
  core::require(
      std::filesystem::is_regular_file(below, ignored),
      fmt::format("{} = \"{}\": there is no such scene file beside this one.", place, *name));
  from.push_back(std::filesystem::canonical(file));
  core::require(
      std::find(from.begin(), from.end(), std::filesystem::canonical(below)) == from.end(),
      fmt::format("{} = \"{}\" is this scene itself or built on it.", place, *name));
  own.erase("base");
  auto tables = read(below, std::move(from));
  put_over(tables, std::move(own));
  return tables;
}

}  // namespace

toml::table read_tables(std::filesystem::path const& file) { return read(file, {}); }

}  // namespace velum::cases
