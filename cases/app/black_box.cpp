#include "cases/app/black_box.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/output/series.hpp"

namespace velum::cases {
namespace {

char const* word(Cause cause)
{
  constexpr std::array words = {"input", "fluid", "contact", "structure", "none"};
  return words[static_cast<std::size_t>(cause)];
}

double usual(BlackBox const& box, std::size_t quantity)
{
  std::vector<double> old;
  for (std::size_t k = 0; k < (box.rows.size() + 1) / 2; ++k)
    if (double const v = box.rows[k].values[quantity]; std::isfinite(v)) old.push_back(std::abs(v));
  if (old.empty()) return box.watched[quantity].usual;
  auto const middle = old.begin() + static_cast<std::ptrdiff_t>(old.size() / 2);
  std::nth_element(old.begin(), middle, old.end());
  return std::max(*middle, box.watched[quantity].usual);
}

/// Magnitude over what is usual; infinite where it is no number, 0 where it is not judged.
double ratio(Watched const& what, double value, double usual)
{
  if (what.cause == Cause::none) return 0;
  return std::isfinite(value) ? std::abs(value) / usual : std::numeric_limits<double>::infinity();
}

/// Departures of one box: within its last rows of which each has some quantity out of its range.
std::vector<Departure> departures(BlackBox const& box)
{
  std::size_t const count = box.watched.size();
  std::vector<double> range(count);
  for (std::size_t q = 0; q < count; ++q) range[q] = usual(box, q);
  std::vector<std::optional<Departure>> found(count);
  for (auto row = box.rows.rbegin(); row != box.rows.rend(); ++row) {
    bool any = false;
    for (std::size_t q = 0; q < count; ++q) {
      double const r = ratio(box.watched[q], row->values[q], range[q]);
      if (!(r > departs_at)) continue;
      any = true;
      double const most = found[q] ? std::max(found[q]->ratio, r) : r;
      found[q] = {box.watched[q], row->step, row->time, most};
    }
    if (!any) break;
  }
  std::vector<Departure> all;
  for (auto const& f : found)
    if (f) all.push_back(*f);
  return all;
}

bool earlier(Departure const& a, Departure const& b)
{
  if (a.step != b.step) return a.step < b.step;
  return a.what.cause < b.what.cause;
}

}  // namespace

void note(BlackBox& box, long step, double time, std::vector<double> values)
{
  if (box.rows.size() == box.capacity) box.rows.pop_front();
  box.rows.push_back({step, time, std::move(values)});
}

std::vector<Departure> departures(std::vector<BlackBox const*> const& boxes)
{
  std::vector<Departure> all, first;
  for (auto const* box : boxes) {
    auto const more = departures(*box);
    all.insert(all.end(), more.begin(), more.end());
  }
  std::stable_sort(all.begin(), all.end(), earlier);
  for (auto const& d : all)
    if (std::none_of(first.begin(), first.end(),
                     [&](Departure const& f) { return f.what.cause == d.what.cause; }))
      first.push_back(d);
  return first;
}

std::string in_words(std::vector<Departure> const& departures)
{
  std::string text;
  for (auto const& d : departures)
    text += fmt::format("{}{} ({} {:.2g} times its usual, from step {}, t = {:.4g} s)",
                        text.empty() ? "Left its usual range first: " : ", then ",
                        word(d.what.cause), d.what.name, d.ratio, d.step, d.time);
  return text.empty() ? text : text + ".";
}

void write(BlackBox const& box, std::filesystem::path const& file)
{
  std::vector<core::Column> columns = {{"step", "1"}};
  for (auto const& q : box.watched) columns.push_back({q.name, q.unit});
  auto series = core::start_series(file, columns);
  for (auto const& row : box.rows) {
    std::vector<double> values = {double(row.step)};
    values.insert(values.end(), row.values.begin(), row.values.end());
    core::append(series, row.time, values);
  }
}

}  // namespace velum::cases
