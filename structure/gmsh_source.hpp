#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace velum::structure {

static_assert(std::endian::native == std::endian::little, "binary MSH is read as it lies");

/// The bytes of a MSH file from front to back: words of text, and values, which are words too where
/// the file is ASCII and as in memory where it is binary. Every way to read either moves on by a
/// byte at least or throws, so that no promise of the file is trusted.
class GmshSource {
 public:
  GmshSource(std::string bytes, std::string name) : bytes_(std::move(bytes)), name_(std::move(name))
  {
  }

  bool binary = false;

  /// Whether only blanks are left.
  bool at_end();
  /// The next word. @param what  it should be, for the sentence: "the number of nodes"
  std::string_view word(std::string_view what);
  /// The next word, which must be this one.
  void expect(std::string_view word);
  /// The text up to the end of the line.
  std::string_view rest_of_line();
  /// What follows the next appearance of this word.
  void skip_past(std::string_view word);
  /// A whole number in text, as counts are even in binary files of version 2.2.
  std::int64_t number(std::string_view what);
  /// In a binary file, values begin on the next line.
  void begin_values();
  /// A std::int32_t, std::uint64_t or finite double.
  template <class T>
  T value(std::string_view what);

  /// Throws InputError: the file, the line or byte of what was read last, and the sentence.
  [[noreturn]] void refuse(std::string const& sentence) const;
  std::string const& name() const { return name_; }

 private:
  [[noreturn]] void refuse_word(std::string_view found, std::string_view what) const;
  template <class T>
  T parse(std::string_view what);

  std::string bytes_, name_;
  std::size_t at_ = 0;     // the next byte
  std::size_t start_ = 0;  // of what was read last
};

}  // namespace velum::structure
