#include "cases/app/oscillation.hpp"

#include <algorithm>
#include <cstddef>

#include "cases/app/curve.hpp"

namespace velum::cases {
namespace {

std::size_t index_of_largest(std::vector<double> const& time, std::vector<double> const& value,
                             double begin, double end)
{
  std::size_t best = time.size() - 1;
  bool found = false;
  for (std::size_t k = 0; k < time.size(); ++k)
    if (time[k] >= begin && time[k] <= end && (!found || value[k] > value[best])) {
      best = k;
      found = true;
    }
  return best;
}

}  // namespace

std::optional<Oscillation> last_periods(std::vector<double> const& time,
                                        std::vector<double> const& value, double noise)
{
  if (time.size() < 8) return {};
  std::size_t const half = time.size() / 2;
  auto const [lo, hi] =
      std::minmax_element(value.begin() + static_cast<std::ptrdiff_t>(half), value.end());
  if (*hi - *lo < 2 * noise) return {};
  double const middle = mean(time, value, time[half], time.back());
  std::vector<double> crossings;
  for (std::size_t k = half + 1; k < time.size(); ++k)
    if (value[k - 1] < middle && value[k] >= middle)
      crossings.push_back(time[k - 1] + (time[k] - time[k - 1]) * (middle - value[k - 1]) /
                                            (value[k] - value[k - 1]));
  if (crossings.size() < 2) return {};
  std::size_t const periods = std::min<std::size_t>(crossings.size() - 1, 3);
  double const end = crossings.back(), begin = crossings[crossings.size() - 1 - periods];
  double const period = (end - begin) / double(periods);
  double const top = time[index_of_largest(time, value, end - period, end)];
  return Oscillation{begin, end, period, top};
}

double mean(std::vector<double> const& time, std::vector<double> const& value, double begin,
            double end)
{
  double sum = 0, length = 0;
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k - 1] < begin || time[k] > end) continue;
    sum += (time[k] - time[k - 1]) * (value[k] + value[k - 1]) / 2;
    length += time[k] - time[k - 1];
  }
  return length > 0 ? sum / length : value.back();
}

double largest(std::vector<double> const& time, std::vector<double> const& value, double begin,
               double end)
{
  std::size_t const k = index_of_largest(time, value, begin, end);
  if (k == 0 || k + 1 >= time.size()) return value[k];
  double const slope = (value[k + 1] - value[k - 1]) / 2;
  double const bend = value[k + 1] - 2 * value[k] + value[k - 1];
  return bend < 0 ? value[k] - slope * slope / (2 * bend) : value[k];
}

double at_time(std::vector<double> const& time, std::vector<double> const& value, double t)
{
  return value_at({time, value}, t);
}

}  // namespace velum::cases
