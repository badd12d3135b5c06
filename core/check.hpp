#pragma once
#include <stdexcept>
#include <string>

namespace velum::core {

/// What the user asked for cannot be done; the text is the whole sentence shown. Exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run left the range where its numbers mean anything: step, place, likely cause. Exit code 3.
struct Divergence : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws InputError(sentence) unless the condition holds. Host only.
inline void require(bool condition, std::string const& sentence)
{
  if (!condition) throw InputError(sentence);
}

}  // namespace velum::core
