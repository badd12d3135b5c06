#include "cases/app/overrides.hpp"

#include "core/check.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace velum::cases {
namespace {

std::string_view trim(std::string_view text)
{
  auto const first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

[[noreturn]] void refuse(std::string_view key, std::string_view what)
{
  throw core::InputError(fmt::format("--set: {} {}", key, what));
}

/// The table { v = text }, or nothing when the text is not a TOML value.
std::optional<toml::table> parse_value(std::string const& text)
{
  try {
    return toml::parse("v = " + text + '\n');
  } catch (toml::parse_error const&) {
    return {};
  }
}

/// Puts quotes around the bare words between the brackets and commas of an array.
std::string quote_words(std::string_view text)
{
  std::string quoted;
  while (!text.empty()) {
    auto const end = std::min(text.find_first_of("[],"), text.size());
    auto const word = trim(text.substr(0, end));
    bool const bare = !word.empty() && !parse_value(std::string(word));
    quoted += bare ? fmt::format("\"{}\"", word) : std::string(word);
    if (end == text.size()) break;
    quoted += text[end];
    text.remove_prefix(end + 1);
  }
  return quoted;
}

toml::table read_value(std::string_view key, std::string_view text)
{
  text = trim(text);
  if (text.empty()) refuse(key, "has no value; write key=value.");
  if (auto value = parse_value(std::string(text))) return *std::move(value);
  if (text.front() == '[')
    if (auto value = parse_value(quote_words(text))) return *std::move(value);
  return toml::table{{"v", std::string(text)}};
}

struct Step {
  std::string key;
  std::vector<std::size_t> indices;
};

/// "inlet.patches[0].from" -> inlet, patches [0], from.
std::vector<Step> split(std::string_view path)
{
  std::vector<Step> steps;
  std::string_view rest = path;
  while (true) {
    auto const dot = std::min(rest.find('.'), rest.size());
    std::string_view part = trim(rest.substr(0, dot));
    auto const bracket = std::min(part.find('['), part.size());
    Step step{std::string(part.substr(0, bracket)), {}};
    part.remove_prefix(bracket);
    while (!part.empty()) {
      std::size_t index = 0;
      auto const [end, error] = std::from_chars(part.data() + 1, part.data() + part.size(), index);
      auto const used = static_cast<std::size_t>(end - part.data());
      if (part.front() != '[' || error != std::errc{} || used >= part.size() || *end != ']')
        refuse(path, "is not a key; keys look like inlet.pressure or inlet.patches[0].from.");
      step.indices.push_back(index);
      part.remove_prefix(used + 1);
    }
    if (step.key.empty())
      refuse(path, "is not a key; keys look like inlet.pressure or inlet.patches[0].from.");
    steps.push_back(std::move(step));
    if (dot == rest.size()) return steps;
    rest.remove_prefix(dot + 1);
  }
}

std::string missing_member(toml::table const& group, Step const& step)
{
  std::vector<std::string> names;
  for (auto const& [name, node] : group) names.emplace_back(name.str());
  std::string const near = core::nearest(step.key, names);
  return near.empty() ? fmt::format("does not exist; the scene has {}.", core::any_of(names))
                      : fmt::format("does not exist; did you mean \"{}\"?", near);
}

/// The table that a step of the path leads into; made where the scene leaves it out.
toml::table& descend(toml::table& from, Step const& step, std::string const& path, bool named)
{
  if (!from.contains(step.key) && step.indices.empty()) {
    if (named) refuse(path, missing_member(from, step));
    from.insert(step.key, toml::table{});
  }
  toml::node* node = from.get(step.key);
  for (std::size_t const index : step.indices)
    node = node && node->is_array() ? node->as_array()->get(index) : nullptr;
  if (!node) refuse(path, "does not exist.");
  if (!node->is_table()) refuse(path, "is a value, not a table of further keys.");
  return *node->as_table();
}

void assign(toml::table& table, Step const& step, std::string const& path, toml::node const& value)
{
  if (step.indices.empty()) {
    value.visit([&](auto const& typed) { table.insert_or_assign(step.key, typed); });
    return;
  }
  toml::node* node = table.get(step.key);
  for (std::size_t k = 0; k < step.indices.size(); ++k) {
    auto* array = node ? node->as_array() : nullptr;
    if (!array || step.indices[k] >= array->size()) refuse(path, "does not exist.");
    auto const at = static_cast<std::ptrdiff_t>(step.indices[k]);
    if (k + 1 == step.indices.size())
      value.visit([&](auto const& typed) { array->replace(array->cbegin() + at, typed); });
    else
      node = array->get(step.indices[k]);
  }
}

}  // namespace

std::string apply_override(toml::table& scene, std::string const& text)
{
  auto const equals = text.find('=');
  if (equals == std::string::npos)
    refuse('"' + text + '"', "is not of the form key=value, such as inlet.pressure=\"300 kPa\".");
  std::string const key(trim(std::string_view(text).substr(0, equals)));
  auto const steps = split(key);
  toml::table const value = read_value(key, std::string_view(text).substr(equals + 1));

  toml::table* table = &scene;
  std::string path;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    bool const named =
        k == 1 && (path == "solid" || path == "material" || path == "boundary" || path == "probe");
    path += (path.empty() ? "" : ".") + steps[k].key;
    for (auto const index : steps[k].indices) path += fmt::format("[{}]", index);
    table = &descend(*table, steps[k], path, named);
  }
  assign(*table, steps.back(), key, *value.get("v"));
  return key;
}

}  // namespace velum::cases
