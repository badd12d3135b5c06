#include "cases/app/scene_text.hpp"

#include "core/check.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>

namespace velum::cases {

toml::table parse_toml(std::filesystem::path const& file, std::string_view what)
{
  std::error_code ignored;
  core::require(std::filesystem::exists(file, ignored),
                fmt::format("{}: there is no such {}.", file.string(), what));
  core::require(std::filesystem::is_regular_file(file, ignored),
                fmt::format("{}: is not a file.", file.string()));
  try {
    return toml::parse_file(file.string());
  } catch (toml::parse_error const& error) {
    auto const line = error.source().begin.line;
    throw core::InputError(
        line > 0
            ? fmt::format("{}:{}: is not valid TOML: {}.", file.string(), line, error.description())
            : fmt::format("{}: cannot be read: {}.", file.string(), error.description()));
  }
}

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

std::string example(core::Dimension dimension)
{
  return "1 " + core::usual_units(dimension).front();
}

std::string did_you_mean(std::string_view word, std::vector<std::string> const& words)
{
  std::string const nearest = core::nearest(word, words);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

}  // namespace velum::cases
