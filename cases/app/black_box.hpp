#pragma once
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

namespace velum::cases {

/// What a run may diverge by, in the order in which one step hands on what went wrong: nothing
/// moves the input; the fluid pushes the membrane, and the contact holds against it, in the same
/// step, but the fluid hears of it in the next.
enum class Cause { input, fluid, contact, structure, none };

/// A quantity of the black box; magnitudes up to `usual` are never taken for a departure.
struct Watched {
  std::string name, unit;
  Cause cause;  // none: written and not judged
  double usual = 0;
};

/// The last samples of some quantities.
struct BlackBox {
  struct Row {
    long step;
    double time;  // s
    std::vector<double> values;
  };
  std::vector<Watched> watched;
  std::size_t capacity;
  std::deque<Row> rows{};
};

/// Adds a row, the oldest leaves where the box is full.
void note(BlackBox& box, long step, double time, std::vector<double> values);

/// When a quantity left its usual range.
struct Departure {
  Watched what;
  long step;
  double time;
  double ratio;  // to what was usual, the largest; infinite where it is no number
};

/// A quantity is out of its range above ten times what is usual, the median over the older half of
/// the rows, or where it is no longer finite. It has departed where it first is so, if from there
/// to the end there is always one in its box that is.
constexpr double departs_at = 10;

/// The first departure of each cause in the boxes of a run, the earliest first; at one step in
/// the order of Cause.
std::vector<Departure> departures(std::vector<BlackBox const*> const& boxes);

/// The departures as a sentence: "Left its usual range first: contact (seat_force at step 12 ...)".
/// Empty without any.
std::string in_words(std::vector<Departure> const& departures);

/// The rows as CSV.
void write(BlackBox const& box, std::filesystem::path const& file);

}  // namespace velum::cases
