#include "core/check.hpp"
#include "core/output/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>

namespace velum::core {
namespace {

/// What is still to be read of a summary. It knows no more of JSON than to_json() writes, and
/// throws InputError with what it misses.
struct Reader {
  std::string_view rest;

  bool take(std::string_view token)
  {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    if (!rest.starts_with(token)) return false;
    rest.remove_prefix(token.size());
    return true;
  }

  void expect(std::string_view token)
  {
    require(take(token), fmt::format("'{}' is missing", token));
  }

  char next()
  {
    require(!rest.empty(), "the end is missing");
    char const c = rest.front();
    rest.remove_prefix(1);
    return c;
  }

  /// A character behind a backslash: one that would end the text, or a control character by its
  /// number.
  char escaped()
  {
    char const c = next();
    if (c != 'u') return c;
    unsigned code = 0;
    auto const digits = rest.substr(0, 4);
    auto const [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    require(digits.size() == 4 && end == digits.data() + 4 && code < 0x80, "a character is none");
    rest.remove_prefix(4);
    return static_cast<char>(code);
  }

  std::string text()
  {
    expect("\"");
    std::string out;
    for (char c = next(); c != '"'; c = next()) out += c == '\\' ? escaped() : c;
    return out;
  }

  double number()
  {
    if (take("null")) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    auto const [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    require(error == std::errc{}, "a number is missing");
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return value;
  }

  Figure figure(std::string name)
  {
    expect("{");
    expect("\"value\"");
    expect(":");
    double const value = number();
    expect(",");
    expect("\"unit\"");
    expect(":");
    Figure read{std::move(name), value, text()};
    expect("}");
    return read;
  }

  Assumptions assumptions()
  {
    Assumptions read;
    expect("{");
    if (take("}")) return read;
    do {
      std::string name = text();
      expect(":");
      read.emplace(std::move(name), text());
    } while (take(","));
    expect("}");
    return read;
  }
};

}  // namespace

Summary read_summary(std::filesystem::path const& file)
{
  std::ifstream stream(file, std::ios::binary);
  require(static_cast<bool>(stream), fmt::format("{} cannot be read.", file.string()));
  std::string const text{std::istreambuf_iterator<char>(stream), {}};
  Summary summary;
  Reader reader{text};
  try {
    reader.expect("{");
    do {
      std::string name = reader.text();
      reader.expect(":");
      if (name == "assumptions")
        summary.assumptions = reader.assumptions();
      else
        summary.figures.push_back(reader.figure(std::move(name)));
    } while (reader.take(","));
    reader.expect("}");
  } catch (InputError const& wrong) {
    throw InputError(
        fmt::format("{} is not the summary of a run: {}.", file.string(), wrong.what()));
  }
  return summary;
}

}  // namespace velum::core
