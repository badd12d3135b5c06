#include "core/spelling.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace velum::core {
namespace {

constexpr int edit = 2, wrong_case = 1;

int substitution(char a, char b)
{
  if (a == b) return 0;
  auto const lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? wrong_case : edit;
}

/// Cost of the cheapest edits from a to b, in half edits (optimal string alignment).
int edit_cost(std::string_view a, std::string_view b)
{
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = edit * static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = edit * static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      cost[i][j] = std::min({cost[i - 1][j] + edit, cost[i][j - 1] + edit,
                             cost[i - 1][j - 1] + substitution(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + edit);
    }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string nearest(std::string_view word, std::vector<std::string> const& candidates)
{
  int best = edit * std::max(1, static_cast<int>(word.size()) / 3) + 1;
  std::string found;
  for (auto const& candidate : candidates) {
    int const cost = edit_cost(word, candidate);
    // A word rewritten from end to end is no misspelling, however short it is.
    if (cost < best && cost < edit * static_cast<int>(std::max(word.size(), candidate.size())))
      best = cost, found = candidate;
  }
  return found;
}

std::string any_of(std::vector<std::string> const& words)
{
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) text += k + 1 < words.size() ? ", " : " or ";
    text += words[k];
  }
  return text;
}

}  // namespace velum::core
