#include "core/check.hpp"
#include "core/geometry/stl.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstddef>

namespace velum::core {
namespace {

bool same_word(std::string_view a, std::string_view lower_case)
{
  if (a.size() != lower_case.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    char const c = a[k] >= 'A' && a[k] <= 'Z' ? static_cast<char>(a[k] - 'A' + 'a') : a[k];
    if (c != lower_case[k]) return false;
  }
  return true;
}

/// The words of a text one after the other, with the line each stands in.
class Words {
 public:
  Words(std::string_view text, std::string const& name) : rest_(text), name_(name) {}

  /// The next word, which stays; empty at the end of the text.
  std::string_view peek()
  {
    std::size_t blanks = 0;
    for (; blanks < rest_.size() && is_blank(rest_[blanks]); ++blanks)
      if (rest_[blanks] == '\n') ++line_;
    rest_.remove_prefix(blanks);
    std::size_t length = 0;
    while (length < rest_.size() && !is_blank(rest_[length])) ++length;
    return rest_.substr(0, length);
  }

  std::string_view take()
  {
    auto const word = peek();
    rest_.remove_prefix(word.size());
    return word;
  }

  void expect(std::string_view word)
  {
    auto const found = peek();
    if (!same_word(found, word)) refuse(fmt::format("\"{}\"", word), found);
    take();
  }

  double number()
  {
    auto const word = peek();
    auto const digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
      refuse("a number", word);
    if (error == std::errc::result_out_of_range || !std::isfinite(value))
      throw InputError(fmt::format(
          "{}:{}: \"{}\" is not a finite number, and a corner needs three.", name_, line_, word));
    take();
    return value;
  }

  void skip_line()
  {
    std::size_t const end = rest_.find('\n');
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  [[noreturn]] void refuse(std::string const& expected, std::string_view found) const
  {
    throw InputError(found.empty()
                         ? fmt::format("{}:{}: the file ends where an ASCII STL file has {}.",
                                       name_, line_, expected)
                         : fmt::format("{}:{}: \"{}\" stands where an ASCII STL file has {}.",
                                       name_, line_, found.substr(0, 40), expected));
  }

  std::string_view rest_;
  std::string const& name_;
  int line_ = 1;
};

Facet parse_facet(Words& words)
{
  words.expect("facet");
  words.expect("normal");
  for (int k = 0; k < 3; ++k) words.take();  // not used, and "nan" where the triangle has no area
  words.expect("outer");
  words.expect("loop");
  Facet facet;
  for (auto& corner : facet) {
    words.expect("vertex");
    for (double& x : corner.c) x = words.number();
  }
  words.expect("endloop");
  words.expect("endfacet");
  return facet;
}

}  // namespace

std::vector<Facet> parse_ascii_stl(std::string_view text, std::string const& name)
{
  Words words(text, name);
  std::vector<Facet> facets;
  do {
    words.expect("solid");
    words.skip_line();  // the name of the solid
    while (!same_word(words.peek(), "endsolid")) facets.push_back(parse_facet(words));
    words.take();
    words.skip_line();
  } while (!words.peek().empty());
  return facets;
}

}  // namespace velum::core
