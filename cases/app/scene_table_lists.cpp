#include "cases/app/scene_table.hpp"
#include "cases/app/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

/// The part of SceneTable that reads values which are arrays.
namespace velum::cases {

toml::array const& SceneTable::row_of_two(toml::node const& node, std::string const& path,
                                          std::string const& what) const
{
  auto const* row = node.as_array();
  if (!row || row->size() != 2)
    fail_at(node, path, fmt::format("must be {}, but is {}.", what, describe(node)));
  return *row;
}

Vec2 SceneTable::point_of(toml::node const& node, std::string const& path) const
{
  auto const& row = row_of_two(node, path, "two lengths, such as [\"1 mm\", \"2 mm\"]");
  return {quantity_of(*row.get(0), path + "[0]", core::Dimension::length, Sign::any),
          quantity_of(*row.get(1), path + "[1]", core::Dimension::length, Sign::any)};
}

Vec2 SceneTable::point(std::string const& key, std::optional<Vec2> fallback)
{
  if (fallback && !has(key)) return *fallback;
  return point_of(require(key, "two lengths, such as [\"1 mm\", \"2 mm\"]"), full(key));
}

Vec2 SceneTable::vector(std::string const& key, core::Dimension dimension)
{
  std::string const wanted =
      fmt::format("two values, such as [\"{0}\", \"{0}\"]", example(dimension));
  auto const& row = row_of_two(require(key, wanted), full(key), wanted);
  return {quantity_of(*row.get(0), full(key) + "[0]", dimension, Sign::any),
          quantity_of(*row.get(1), full(key) + "[1]", dimension, Sign::any)};
}

std::vector<double> SceneTable::quantities(std::string const& key, core::Dimension dimension)
{
  std::string const wanted =
      fmt::format("an array of values, such as [\"{}\"]", example(dimension));
  auto const& node = require(key, wanted);
  auto const* entries = node.as_array();
  if (!entries || entries->empty())
    fail_at(node, full(key), fmt::format("must be {}, but is {}.", wanted, describe(node)));
  std::vector<double> values;
  for (std::size_t k = 0; k < entries->size(); ++k)
    values.push_back(quantity_of(*entries->get(k), fmt::format("{}[{}]", full(key), k), dimension,
                                 Sign::positive));
  return values;
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
    points.push_back(point_of(*rows->get(k), fmt::format("{}[{}]", full(key), k)));
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
    auto const& entry = row_of_two(*rows->get(k), path, "a row " + row);
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
