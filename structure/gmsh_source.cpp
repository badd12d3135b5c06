#include "structure/gmsh_source.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace velum::structure {
namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// A word fit for a sentence: not too long, and without bytes that are no letters.
std::string shown(std::string_view word)
{
  std::string text(word.substr(0, 40));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

}  // namespace

void GmshSource::refuse(std::string const& sentence) const
{
  auto const place = bytes_.begin() + static_cast<std::ptrdiff_t>(start_);
  throw core::InputError(
      binary
          ? fmt::format("{}: at byte {}: {}", name_, start_, sentence)
          : fmt::format("{}:{}: {}", name_, 1 + std::count(bytes_.begin(), place, '\n'), sentence));
}

void GmshSource::refuse_word(std::string_view found, std::string_view what) const
{
  refuse(found.empty() ? fmt::format("the file ends where it should have {}.", what)
                       : fmt::format("\"{}\" stands where a MSH file has {}.", shown(found), what));
}

bool GmshSource::at_end()
{
  while (at_ < bytes_.size() && is_blank(bytes_[at_])) ++at_;
  return at_ == bytes_.size();
}

std::string_view GmshSource::word(std::string_view what)
{
  bool const none = at_end();
  start_ = at_;
  if (none) refuse_word("", what);
  while (at_ < bytes_.size() && !is_blank(bytes_[at_])) ++at_;
  return std::string_view(bytes_).substr(start_, at_ - start_);
}

void GmshSource::expect(std::string_view wanted)
{
  auto const found = word(wanted);
  if (found != wanted) refuse_word(found, wanted);
}

std::string_view GmshSource::rest_of_line()
{
  start_ = at_;
  at_ = std::min(bytes_.find('\n', at_), bytes_.size());
  return std::string_view(bytes_).substr(start_, at_ - start_);
}

void GmshSource::skip_past(std::string_view wanted)
{
  start_ = at_;
  for (std::size_t from = at_;;) {
    from = bytes_.find(wanted, from);
    if (from == std::string::npos) refuse_word("", wanted);
    from += wanted.size();
    if (from < bytes_.size() && !is_blank(bytes_[from])) continue;
    at_ = from;
    return;
  }
}

void GmshSource::begin_values()
{
  if (!binary) return;
  for (char const c : rest_of_line())
    if (!is_blank(c)) refuse("text stands where the values of a binary file begin on a new line.");
  at_ = std::min(at_ + 1, bytes_.size());
}

template <class T>
T GmshSource::parse(std::string_view what)
{
  auto const found = word(what);
  auto const digits = found.substr(found.starts_with('+') ? 1 : 0);
  T value{};
  auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) refuse_word(found, what);
  return value;
}

std::int64_t GmshSource::number(std::string_view what) { return parse<std::int64_t>(what); }

template <class T>
T GmshSource::value(std::string_view what)
{
  T value{};
  if (binary) {
    start_ = at_;
    if (bytes_.size() - at_ < sizeof value) refuse_word("", what);
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
  } else {
    value = parse<T>(what);
  }
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(value)) refuse(fmt::format("{} is not a finite number.", what));
  return value;
}

template std::int32_t GmshSource::value(std::string_view);
template std::uint64_t GmshSource::value(std::string_view);
template double GmshSource::value(std::string_view);

}  // namespace velum::structure
