#include "cases/app/scene_table.hpp"

#include "core/check.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace velum::cases {
namespace {

/// What a node is, in words.
std::string describe(toml::node const& node)
{
  if (auto const* text = node.as_string()) return fmt::format("the text \"{}\"", text->get());
  if (auto const* number = node.as_integer()) return fmt::format("the number {}", number->get());
  if (auto const* number = node.as_floating_point())
    return fmt::format("the number {}", number->get());
  if (auto const* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (auto const* rows = node.as_array())
    return fmt::format("an array of {} value{}", rows->size(), rows->size() == 1 ? "" : "s");
  return node.is_table() ? "a table" : "a date or time";
}

/// A value of that dimension as it is written.
std::string example(core::Dimension dimension)
{
  return "1 " + core::usual_units(dimension).front();
}

std::string did_you_mean(std::string_view word, std::vector<std::string> const& words)
{
  std::string const nearest = core::nearest(word, words);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

bool is_within(std::string const& path, std::string const& outer)
{
  return path == outer || path.starts_with(outer + '.') || path.starts_with(outer + '[');
}

}  // namespace

SceneTable::SceneTable(toml::table const& table, std::string path, Origins& origins)
    : table_(&table), path_(std::move(path)), origins_(&origins)
{
  origins_->places[path_] = place(path_, table);
}

bool SceneTable::has(std::string const& key) const { return table_->contains(key); }

std::string SceneTable::full(std::string const& key) const
{
  return path_.empty() ? key : path_ + '.' + key;
}

std::string SceneTable::place(std::string const& path, toml::node const& node) const
{
  for (auto const& key : origins_->overridden)
    if (is_within(path, key)) return "--set";
  auto const line = node.source().begin.line;
  if (line > 0 && !path.empty()) return fmt::format("{}:{}", origins_->file, line);
  for (auto const& key : origins_->overridden)
    if (is_within(key, path)) return "--set";
  return origins_->file;
}

void SceneTable::fail_at(toml::node const& node, std::string const& path,
                         std::string const& what) const
{
  throw core::InputError(fmt::format("{}: {} {}", place(path, node), path, what));
}

void SceneTable::fail(std::string const& key, std::string const& what) const
{
  if (auto const* node = table_->get(key)) fail_at(*node, full(key), what);
  throw core::InputError(fmt::format("{}: {} {}", place(path_, *table_), full(key), what));
}

void SceneTable::allow(std::vector<std::string> const& keys, std::string const& condition) const
{
  for (auto const& [key, node] : *table_) {
    std::string const name(key.str());
    if (std::find(keys.begin(), keys.end(), name) != keys.end()) continue;
    std::string const where = path_.empty() ? "the scene" : '[' + path_ + ']';
    std::string const hint = did_you_mean(name, keys);
    fail(name, fmt::format("is not a key of {}{}{} Allowed: {}.", where, condition,
                           hint.empty() ? "." : hint, fmt::join(keys, ", ")));
  }
}

toml::node const* SceneTable::find(std::string const& key)
{
  auto const* node = table_->get(key);
  if (node) origins_->places[full(key)] = place(full(key), *node);
  return node;
}

toml::node const& SceneTable::require(std::string const& key, std::string const& what)
{
  auto const* node = find(key);
  if (!node) fail(key, "is missing; it must be " + what + '.');
  return *node;
}

double SceneTable::quantity_of(toml::node const& node, std::string const& path,
                               core::Dimension dimension, Sign sign) const
{
  auto const* text = node.as_string();
  if (!text)
    fail_at(node, path,
            fmt::format("must be {} written as text with its unit, such as \"{}\", but is {}.",
                        core::name(dimension), example(dimension), describe(node)));
  double value = 0;
  try {
    value = core::parse_quantity(text->get(), dimension);
  } catch (core::InputError const& error) {
    throw core::InputError(fmt::format("{}: {}: {}", place(path, node), path, error.what()));
  }
  if (!std::isfinite(value))
    fail_at(node, path, fmt::format("must be finite, but is \"{}\".", text->get()));
  if (sign == Sign::positive && value <= 0)
    fail_at(node, path, fmt::format("must be positive, but is \"{}\".", text->get()));
  if (sign == Sign::not_negative && value < 0)
    fail_at(node, path, fmt::format("must not be negative, but is \"{}\".", text->get()));
  return value;
}

double SceneTable::quantity(std::string const& key, core::Dimension dimension, Sign sign,
                            std::optional<double> fallback)
{
  if (fallback && !has(key)) return *fallback;
  auto const& node =
      require(key, fmt::format("{}, such as \"{}\"", core::name(dimension), example(dimension)));
  return quantity_of(node, full(key), dimension, sign);
}

std::optional<double> SceneTable::quantity_or_auto(std::string const& key,
                                                   core::Dimension dimension)
{
  auto const* node = find(key);
  if (!node || node->value<std::string_view>() == "auto") return {};
  return quantity_of(*node, full(key), dimension, Sign::positive);
}

std::optional<double> SceneTable::pressure_per_length_or_auto(std::string const& key)
{
  auto const* node = find(key);
  if (!node || node->value<std::string_view>() == "auto") return {};
  auto const text = node->value_exact<std::string>();
  try {
    // A pressure per length, times one metre, is a pressure.
    double const value = text ? core::parse_quantity(*text + " m", core::Dimension::pressure) : 0.0;
    if (value > 0) return value;
  } catch (core::InputError const&) {
  }
  fail_at(*node, full(key),
          fmt::format("must be \"auto\" or a positive pressure per length, such as \"1e11 Pa/m\" "
                      "or \"100 MPa/mm\", but is {}.",
                      describe(*node)));
}

double SceneTable::number(std::string const& key, double fallback)
{
  auto const* node = find(key);
  if (!node) return fallback;
  auto const value = node->value<double>();
  if (!value || !node->is_number() || !std::isfinite(*value) || *value <= 0)
    fail_at(*node, full(key),
            fmt::format("must be a positive number without unit, but is {}.", describe(*node)));
  return *value;
}

std::string SceneTable::text(std::string const& key)
{
  auto const& node = require(key, "text in quotes");
  auto const* text = node.as_string();
  if (!text || text->get().empty())
    fail_at(node, full(key), fmt::format("must be text in quotes, but is {}.", describe(node)));
  return text->get();
}

std::string SceneTable::word_of(std::string const& key, std::vector<std::string> const& words,
                                bool required)
{
  if (!required && !has(key)) return {};
  auto const& node = require(key, fmt::format("one of {}", fmt::join(words, ", ")));
  auto const given = node.value_exact<std::string>();
  if (!given || std::find(words.begin(), words.end(), *given) == words.end()) {
    std::string const hint = given ? did_you_mean(*given, words) : "";
    fail_at(node, full(key),
            fmt::format("cannot be {}{} Allowed: {}.", describe(node), hint.empty() ? "." : hint,
                        fmt::join(words, ", ")));
  }
  return *given;
}

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

SceneTable SceneTable::table(std::string const& key)
{
  auto const& node = require(key, "a table [" + full(key) + ']');
  if (!node.is_table())
    fail_at(node, full(key), fmt::format("must be a table, but is {}.", describe(node)));
  return {*node.as_table(), full(key), *origins_};
}

std::vector<std::pair<std::string, SceneTable>> SceneTable::tables()
{
  std::vector<std::pair<std::string, SceneTable>> all;
  for (auto const& [key, node] : *table_)
    all.emplace_back(std::string(key.str()), table(std::string(key.str())));
  return all;
}

std::vector<SceneTable> SceneTable::list(std::string const& key)
{
  std::string const wanted = "an array with at least one table";
  auto const& node = require(key, wanted);
  auto const* entries = node.as_array();
  if (!entries || entries->empty())
    fail_at(node, full(key), fmt::format("must be {}, but is {}.", wanted, describe(node)));
  std::vector<SceneTable> all;
  for (std::size_t k = 0; k < entries->size(); ++k) {
    std::string const path = fmt::format("{}[{}]", full(key), k);
    auto const& entry = *entries->get(k);
    if (!entry.is_table())
      fail_at(entry, path, fmt::format("must be a table, but is {}.", describe(entry)));
    all.emplace_back(*entry.as_table(), path, *origins_);
  }
  return all;
}

}  // namespace velum::cases
