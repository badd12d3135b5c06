#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace velum::core {

/// The candidate that differs least from the word, for "did you mean ..."; empty when none is near.
///
/// Distance: edits by insertion, deletion, substitution and swapped neighbours (Damerau 1964,
/// doi:10.1145/363958.363994), a wrong case counting half. Near: at most one edit in three letters.
std::string nearest(std::string_view word, std::vector<std::string> const& candidates);

/// The words joined for a sentence: "a", "a or b", "a, b or c".
std::string any_of(std::vector<std::string> const& words);

}  // namespace velum::core
