#include "cases/app/csv_text.hpp"
#include "cases/app/sweep.hpp"
#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace velum::cases {
namespace {

constexpr std::size_t longest_in_name = 24;  // characters of a value

[[noreturn]] void refuse(std::string const& what) { throw core::InputError("--over: " + what); }

/// Splits at the commas that stand within no bracket, brace or quotation mark (' or ", the latter
/// with \" inside, as in TOML).
std::vector<std::string> split_values(std::string const& key, std::string const& text)
{
  std::vector<std::string> values{""};
  std::string open;  // the brackets that wait for their end
  char quote = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    char const c = text[k];
    if (c == ',' && open.empty() && !quote) {
      values.emplace_back();
      continue;
    }
    values.back() += c;
    if (quote == '"' && c == '\\' && k + 1 < text.size()) {
      values.back() += text[++k];
    } else if (quote) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      open += c == '[' ? ']' : '}';
    } else if (c == ']' || c == '}') {
      if (open.empty() || open.back() != c)
        refuse(fmt::format("{} has a {} that closes nothing.", key, c));
      open.pop_back();
    }
  }
  if (quote) refuse(fmt::format("{} has a quotation mark {} that is not closed.", key, quote));
  if (!open.empty()) refuse(fmt::format("{} lacks a {}.", key, open.back()));
  return values;
}

SweepAxis read_axis(std::string const& text)
{
  auto const equals = text.find('=');
  if (equals == std::string::npos)
    refuse(
        fmt::format("\"{}\" is not of the form key=value,value, such as "
                    "inlet.pressure=\"50 kPa,100 kPa\".",
                    text));
  SweepAxis axis{trimmed(text.substr(0, equals)), {}};
  if (trimmed(text.substr(equals + 1)).empty())
    refuse(fmt::format("{} has no value; write key=value,value.", axis.key));
  for (auto const& part : split_values(axis.key, text.substr(equals + 1))) {
    auto const value = trimmed(part);
    if (value.empty()) refuse(axis.key + " has an empty value between its commas.");
    if (std::find(axis.values.begin(), axis.values.end(), value) != axis.values.end())
      refuse(fmt::format("{} has the value {} twice.", axis.key, value));
    axis.values.push_back(value);
  }
  return axis;
}

/// What of a text may stand in the name of a folder: letters, digits, what is not ASCII, - + and .
std::string for_name(std::string const& text)
{
  std::string kept;
  for (char const c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) > 0x7f ||
        c == '-' || c == '+' || c == '.')
      kept += c;
  return kept;
}

/// For each key its last word, where these differ; otherwise the keys.
std::vector<std::string> labels(std::vector<SweepAxis> const& axes)
{
  std::vector<std::string> whole, last;
  for (auto const& axis : axes) {
    whole.push_back(for_name(axis.key));
    auto const dot = axis.key.rfind('.');
    last.push_back(for_name(dot == std::string::npos ? axis.key : axis.key.substr(dot + 1)));
  }
  return std::set(last.begin(), last.end()).size() == last.size() ? last : whole;
}

/// For each value of an axis what stands for it in the name of a folder.
std::vector<std::string> value_names(SweepAxis const& axis)
{
  std::vector<std::string> names;
  for (auto const& value : axis.values) {
    bool const table = value.find_first_of("[{") != std::string::npos;
    names.push_back(table ? "" : for_name(value));
  }
  std::vector<std::string> unique;
  for (std::size_t k = 0; k < names.size(); ++k) {
    bool const fits = !names[k].empty() && names[k].size() <= longest_in_name &&
                      std::count(names.begin(), names.end(), names[k]) == 1;
    unique.push_back(fits ? names[k] : fmt::format("no{}", k + 1));
  }
  return unique;
}

}  // namespace

std::vector<SweepAxis> read_axes(std::vector<std::string> const& texts)
{
  std::vector<SweepAxis> axes;
  for (auto const& text : texts) {
    auto axis = read_axis(text);
    for (auto const& other : axes)
      if (other.key == axis.key)
        refuse(axis.key + " is given twice; write all its values in one list.");
    axes.push_back(std::move(axis));
  }
  return axes;
}

std::vector<SweepRun> sweep_runs(std::vector<SweepAxis> const& axes)
{
  std::vector<SweepRun> runs{{}};
  auto const keys = labels(axes);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    auto const names = value_names(axes[a]);
    std::vector<SweepRun> longer;
    for (auto const& run : runs)
      for (std::size_t k = 0; k < names.size(); ++k) {
        longer.push_back(run);
        longer.back().values.push_back(axes[a].values[k]);
        longer.back().folder += fmt::format("{}{}_{}", a == 0 ? "" : "_", keys[a], names[k]);
      }
    runs = std::move(longer);
  }
  return runs;
}

}  // namespace velum::cases
