#include "contact/near_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace velum::contact {
namespace {

/// A cell's number in each direction: 21 bits, enough for a grid of two million cells to a side.
constexpr int bits = 21;
constexpr double most = (1 << bits) - 1;

struct Cells {
  core::Vec3 origin;
  double size;

  std::uint64_t along(double place, int axis) const
  {
    return static_cast<std::uint64_t>(
        std::clamp(std::floor((place - origin[axis]) / size), 0.0, most));
  }

  /// Calls visit(key) for each cell that a box meets.
  template <class Visit>
  void visit(core::Bounds const& box, Visit const& visit) const
  {
    for (auto i = along(box.lo[0], 0); i <= along(box.hi[0], 0); ++i)
      for (auto j = along(box.lo[1], 1); j <= along(box.hi[1], 1); ++j)
        for (auto k = along(box.lo[2], 2); k <= along(box.hi[2], 2); ++k)
          visit(i | j << bits | k << 2 * bits);
  }
};

bool meet(core::Bounds const& a, core::Bounds const& b)
{
  for (int k = 0; k < 3; ++k)
    if (a.hi[k] < b.lo[k] || b.hi[k] < a.lo[k]) return false;
  return true;
}

/// Cells as large as the boxes of the second list are on average, and no less than a part of the
/// largest box of all, which would fill too many.
Cells cells_of(std::vector<core::Bounds> const& first, std::vector<core::Bounds> const& second)
{
  constexpr double longest = 32;
  core::Bounds all;
  double sum = 0, largest = 0;
  auto const include = [&](core::Bounds const& box, double weight) {
    extend(all, box);
    for (int k = 0; k < 3; ++k) {
      sum += weight * (box.hi[k] - box.lo[k]);
      largest = std::max(largest, box.hi[k] - box.lo[k]);
    }
  };
  for (auto const& box : first) include(box, 0);
  for (auto const& box : second) include(box, 1);
  double const mean = sum / (3 * static_cast<double>(second.size()));
  return {all.lo, std::max({mean, largest / longest, diagonal(all) / most})};
}

}  // namespace

std::vector<Pair> near_pairs(std::vector<core::Bounds> const& first,
                             std::vector<core::Bounds> const& second)
{
  std::vector<Pair> pairs;
  if (first.empty() || second.empty()) return pairs;
  auto const cells = cells_of(first, second);
  if (!(cells.size > 0) || !std::isfinite(cells.size)) return pairs;
  std::vector<std::pair<std::uint64_t, int>> filled;
  for (std::size_t i = 0; i < first.size(); ++i)
    cells.visit(first[i],
                [&](std::uint64_t key) { filled.emplace_back(key, static_cast<int>(i)); });
  std::ranges::sort(filled);
  for (std::size_t j = 0; j < second.size(); ++j)
    cells.visit(second[j], [&](std::uint64_t key) {
      for (auto it = std::ranges::lower_bound(filled, std::pair{key, 0});
           it != filled.end() && it->first == key; ++it)
        if (meet(first[static_cast<std::size_t>(it->second)], second[j]))
          pairs.emplace_back(it->second, static_cast<int>(j));
    });
  std::ranges::sort(pairs);
  auto const twice = std::ranges::unique(pairs);  // a box in several cells
  pairs.erase(twice.begin(), twice.end());
  return pairs;
}

}  // namespace velum::contact
