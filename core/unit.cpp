#include "core/unit.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <utility>

namespace velum::core {
namespace {

struct Symbol {
  std::string_view name;
  Unit unit;
  bool prefixable;
};

constexpr double pi = 3.141592653589793;

constexpr Symbol symbols[] = {
    {"m", {1, 1, {1, 0, 0, 0}}, true},
    {"g", {1, 1000, {0, 1, 0, 0}}, true},
    {"s", {1, 1, {0, 0, 1, 0}}, true},
    {"rad", {1, 1, {0, 0, 0, 1}}, true},
    {"N", {1, 1, {1, 1, -2, 0}}, true},
    {"Pa", {1, 1, {-1, 1, -2, 0}}, true},
    {"bar", {100000, 1, {-1, 1, -2, 0}}, true},
    {"mmHg", {133.322387415, 1, {-1, 1, -2, 0}}, false},
    {"psi", {6894.757293168361, 1, {-1, 1, -2, 0}}, false},
    {"l", {1, 1000, {3, 0, 0, 0}}, true},
    {"L", {1, 1000, {3, 0, 0, 0}}, true},
    {"Hz", {1, 1, {0, 0, -1, 0}}, true},
    {"St", {1, 10000, {2, 0, -1, 0}}, true},
    {"min", {60, 1, {0, 0, 1, 0}}, false},
    {"h", {3600, 1, {0, 0, 1, 0}}, false},
    {"deg", {pi, 180, {0, 0, 0, 1}}, false},
    {"°", {pi, 180, {0, 0, 0, 1}}, false},
    {"%", {1, 100, {0, 0, 0, 0}}, false},
    {"1", {1, 1, {0, 0, 0, 0}}, false},
};

struct Prefix {
  std::string_view name;
  double numerator, denominator;
};

constexpr Prefix prefixes[] = {
    {"G", 1e9, 1}, {"M", 1e6, 1}, {"k", 1e3, 1}, {"h", 1e2, 1}, {"d", 1, 10},  {"c", 1, 100},
    {"m", 1, 1e3}, {"u", 1, 1e6}, {"µ", 1, 1e6}, {"μ", 1, 1e6}, {"n", 1, 1e9}, {"p", 1, 1e12},
};

std::optional<Unit> find_symbol(std::string_view name)
{
  for (auto const& symbol : symbols)
    if (symbol.name == name) return symbol.unit;
  for (auto const& prefix : prefixes) {
    if (!name.starts_with(prefix.name)) continue;
    for (auto const& symbol : symbols) {
      if (!symbol.prefixable || symbol.name != name.substr(prefix.name.size())) continue;
      Unit unit = symbol.unit;
      unit.numerator *= prefix.numerator;
      unit.denominator *= prefix.denominator;
      return unit;
    }
  }
  return {};
}

void multiply(Unit& product, Unit factor, int power)
{
  if (power < 0) std::swap(factor.numerator, factor.denominator);
  for (int k = 0; k < std::abs(power); ++k) {
    product.numerator *= factor.numerator;
    product.denominator *= factor.denominator;
  }
  for (std::size_t d = 0; d < factor.exponents.size(); ++d)
    product.exponents[d] += power * factor.exponents[d];
}

/// Splits "mm2", "mm^2", "mm²", "s-1" into symbol and power; a factor "1" keeps its digit.
std::pair<std::string_view, int> split_power(std::string_view factor)
{
  for (auto const& [superscript, power] : {std::pair{std::string_view{"²"}, 2}, {"³", 3}})
    if (factor.ends_with(superscript))
      return {factor.substr(0, factor.size() - superscript.size()), power};

  std::size_t const last = factor.find_last_not_of("0123456789");
  if (last == std::string_view::npos || last + 1 == factor.size()) return {factor, 1};
  bool const negative = factor[last] == '-';
  std::string_view const digits = factor.substr(negative ? last : last + 1);
  int power = 1;
  auto const error = std::from_chars(digits.begin(), digits.end(), power).ec;
  // No unit has a power above 9; a longer number belongs to a misspelt symbol.
  if (error != std::errc{} || std::abs(power) > 9) return {factor, 1};
  std::string_view symbol = factor.substr(0, negative ? last : last + 1);
  if (symbol.ends_with('^')) symbol.remove_suffix(1);
  return {symbol, power};
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text, std::string& unknown)
{
  constexpr std::string_view separators = " \t*/";
  Unit product;
  bool divide = false, expected = true;  // expected: a factor must follow
  while (true) {
    std::size_t const end = std::min(text.find_first_of(separators), text.size());
    if (end > 0) {
      auto const [symbol, power] = split_power(text.substr(0, end));
      auto const unit = find_symbol(symbol);
      if (!unit) return unknown = text.substr(0, end), std::nullopt;
      multiply(product, *unit, divide ? -power : power);
      divide = expected = false;
    }
    if (end == text.size()) break;
    if (text[end] == '/' || text[end] == '*') {
      if (expected) return unknown = text.substr(0, end + 1), std::nullopt;
      expected = true;
      divide = text[end] == '/';
    }
    text.remove_prefix(end + 1);
  }
  if (expected) return unknown = divide ? "/" : "", std::nullopt;
  return product;
}

}  // namespace velum::core
