#include "cases/app/free_oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/app/oscillation.hpp"

namespace velum::cases {
namespace {

constexpr double least_swing = 1e-3;  // of what the middle did over the whole run

}  // namespace

std::vector<core::Figure> free_oscillation(History const& history)
{
  if (!history.has("centre") || history.time.size() < 3) return {};
  auto const centre = history.column("centre");
  auto const [low, high] = std::minmax_element(centre.begin(), centre.end());
  auto const swing = last_periods(history.time, centre, least_swing * (*high - *low));
  if (!swing) return {};
  std::vector<core::Figure> figures = {{"free_frequency", 1 / swing->period, "Hz"}};
  int const periods = int(std::lround((swing->end - swing->begin) / swing->period));
  if (periods < 2) return figures;
  double const middle = mean(history.time, centre, swing->begin, swing->end);
  auto const turn = [&](int k) {
    double const from = swing->begin + k * swing->period;
    return largest(history.time, centre, from, from + swing->period) - middle;
  };
  double const decrement = std::log(turn(0) / turn(periods - 1)) / (periods - 1);
  figures.push_back({"free_damping_ratio", decrement / (2 * std::numbers::pi), "1"});
  return figures;
}

}  // namespace velum::cases
