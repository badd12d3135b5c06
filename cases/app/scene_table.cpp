#include "cases/app/scene_table.hpp"
#include "cases/app/scene_text.hpp"

#include "core/check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace velum::cases {
namespace {

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
  auto const& file = node.source().path;  // the scene's own or that of its base
  if (line > 0 && !path.empty()) return fmt::format("{}:{}", file ? *file : origins_->file, line);
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
    std::string const where = path_.empty() ? origins_->whole : '[' + path_ + ']';
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
  return node ? number_of(*node, full(key)) : fallback;
}

double SceneTable::any_number(std::string const& key)
{
  auto const& node = require(key, "a number without unit");
  auto const value = node.value<double>();
  if (!value || !node.is_number() || !std::isfinite(*value))
    fail_at(node, full(key),
            fmt::format("must be a number without unit, but is {}.", describe(node)));
  return *value;
}

double SceneTable::number_of(toml::node const& node, std::string const& path) const
{
  auto const value = node.value<double>();
  if (!value || !node.is_number() || !std::isfinite(*value) || *value <= 0)
    fail_at(node, path,
            fmt::format("must be a positive number without unit, but is {}.", describe(node)));
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
