#include "cases/app/scene_table.hpp"
#include "cases/app/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

/// The part of SceneTable that reads values which are arrays.
namespace velum::cases {

namespace {

/// "two lengths, such as ["1 mm", "1 mm"]"
std::string row_wanted(int n, core::Dimension dimension)
{
  std::string const what = dimension == core::Dimension::length ? "lengths" : "values";
  std::string const one = fmt::format("\"{}\"", example(dimension));
  return fmt::format("{} {}, such as [{}]", n == 2 ? "two" : "three", what,
                     fmt::join(std::vector<std::string>(static_cast<std::size_t>(n), one), ", "));
}

}  // namespace

toml::array const& SceneTable::row_of(std::size_t n, toml::node const& node,
                                      std::string const& path, std::string const& what) const
{
  auto const* row = node.as_array();
  if (!row || row->size() != n)
    fail_at(node, path, fmt::format("must be {}, but is {}.", what, describe(node)));
  return *row;
}

Vec3 SceneTable::values_of(int n, toml::node const& node, std::string const& path,
                           core::Dimension dimension) const
{
  auto const& row = row_of(static_cast<std::size_t>(n), node, path, row_wanted(n, dimension));
  Vec3 values;
  for (int a = 0; a < n; ++a)
    values[a] = quantity_of(*row.get(static_cast<std::size_t>(a)), fmt::format("{}[{}]", path, a),
                            dimension, Sign::any);
  return values;
}

Vec3 SceneTable::point(std::string const& key, std::optional<Vec3> fallback)
{
  return fallback && !has(key) ? *fallback : vector(key, core::Dimension::length);
}

Vec3 SceneTable::vector(std::string const& key, core::Dimension dimension)
{
  int const n = dimensions();
  return values_of(n, require(key, row_wanted(n, dimension)), full(key), dimension);
}

Vec2 SceneTable::pair(std::string const& key)
{
  auto const length = core::Dimension::length;
  return core::in_plane(values_of(2, require(key, row_wanted(2, length)), full(key), length));
}

std::string SceneTable::file_name(std::string const& key)
{
  auto const name = text(key);
  if (name.find('/') != std::string::npos)
    fail(key, "must be the name of a file in the folder of the scene, without slashes.");
  return name;
}

std::filesystem::path SceneTable::beside(std::string const& name) const
{
  return std::filesystem::path(origins_->file).parent_path() / name;
}

std::vector<double> SceneTable::quantities(std::string const& key, core::Dimension dimension)
{
  std::string const wanted =
      fmt::format("an array of values, such as [\"{}\"]", example(dimension));
  auto const& entries = entries_of(key, wanted);
  std::vector<double> values;
  for (std::size_t k = 0; k < entries.size(); ++k)
    values.push_back(quantity_of(*entries.get(k), fmt::format("{}[{}]", full(key), k), dimension,
                                 Sign::positive));
  return values;
}

std::vector<double> SceneTable::numbers(std::string const& key)
{
  auto const& entries = entries_of(key, "an array of numbers, such as [1.5]");
  std::vector<double> values;
  for (std::size_t k = 0; k < entries.size(); ++k)
    values.push_back(number_of(*entries.get(k), fmt::format("{}[{}]", full(key), k)));
  return values;
}

toml::array const& SceneTable::entries_of(std::string const& key, std::string const& wanted)
{
  auto const& node = require(key, wanted);
  auto const* entries = node.as_array();
  if (!entries || entries->empty())
    fail_at(node, full(key), fmt::format("must be {}, but is {}.", wanted, describe(node)));
  return *entries;
}

std::vector<std::string> SceneTable::texts(std::string const& key,
                                           std::vector<std::string> const& words)
{
  std::string const wanted = fmt::format("an array with any of \"{}\"", fmt::join(words, "\", \""));
  auto const& node = require(key, wanted);
  auto const* entries = node.as_array();
  if (!entries)
    fail_at(node, full(key), fmt::format("must be {}, but is {}.", wanted, describe(node)));
  std::vector<std::string> given;
  for (auto const& entry : *entries) {
    auto const text = entry.value_exact<std::string>();
    if (!text || std::find(words.begin(), words.end(), *text) == words.end())
      fail_at(node, full(key),
              fmt::format(
                  "holds {}{} It must be {}.", describe(entry),
                  text && !did_you_mean(*text, words).empty() ? did_you_mean(*text, words) : ".",
                  wanted));
    if (std::find(given.begin(), given.end(), *text) != given.end())
      fail_at(node, full(key), fmt::format("holds \"{}\" twice.", *text));
    given.push_back(*text);
  }
  return given;
}

std::vector<Vec2> SceneTable::points(std::string const& key)
{
  std::string const wanted = "an array of points, such as [[\"0 mm\", \"1 mm\"], ...]";
  auto const& node = require(key, wanted);
  auto const* rows = node.as_array();
  if (!rows) fail_at(node, full(key), "must be " + wanted + ", but is " + describe(node) + '.');
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < rows->size(); ++k)
    points.push_back(core::in_plane(
        values_of(2, *rows->get(k), fmt::format("{}[{}]", full(key), k), core::Dimension::length)));
  return points;
}

Curve SceneTable::curve(std::string const& key, core::Dimension argument, core::Dimension value,
                        Sign sign, std::optional<double> fallback)
{
  if (fallback && !has(key)) return constant(*fallback);
  std::string const row = fmt::format("[\"{}\", \"{}\"]", example(argument), example(value));
  auto const& node = require(key, fmt::format("{}, such as \"{}\", or a table of rows {}",
                                              core::name(value), example(value), row));
  auto const* rows = node.as_array();
  if (!rows) return constant(quantity_of(node, full(key), value, sign));
  if (rows->empty()) fail_at(node, full(key), fmt::format("is an empty table; rows are {}.", row));

  Curve curve;
  for (std::size_t k = 0; k < rows->size(); ++k) {
    std::string const path = fmt::format("{}[{}]", full(key), k);
    auto const& entry = row_of(2, *rows->get(k), path, "a row " + row);
    double const at = quantity_of(*entry.get(0), path + "[0]", argument, Sign::any);
    if (k > 0 && at <= curve.at.back())
      fail_at(entry, path,
              fmt::format("must follow the row before it: the first column of the "
                          "table {} has to increase strictly.",
                          full(key)));
    curve.at.push_back(at);
    curve.value.push_back(quantity_of(*entry.get(1), path + "[1]", value, sign));
  }
  return curve;
}

}  // namespace velum::cases
