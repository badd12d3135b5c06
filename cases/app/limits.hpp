#pragma once
#include "cases/app/scene.hpp"

#include <functional>
#include <string>
#include <vector>

/// Where a collision loses stability: bisection of the largest Reynolds or Mach number that a flow
/// survives.
namespace velum::cases {

/// One way to compute a map's flow.
struct LimitPoint {
  Collision collision;
  bool les;
  double mach, reynolds;
};

/// A flow to try.
struct LimitMap {
  std::string name, what;
  std::function<Scene(LimitPoint const&, int cells)> scene;
  int cells;  // across the flow, unless asked for otherwise
};

/// All maps by name.
std::vector<LimitMap> const& limit_maps();

/// One limit found.
struct LimitRow {
  Collision collision;
  bool les;
  std::string quantity;   // "reynolds" or "mach": which number is the limit
  double mach, reynolds;  // the larger one tried that was stable; its other number as given
  double tau_minus_half;  // of that run
  std::string bound;      // "found"; "none" where all were stable, "all" where none was
  std::string beyond;     // the sentence of the least number that diverged; empty with "none"
};

/// Reynolds numbers that are tried, and Mach numbers.
constexpr double least_reynolds = 1e2, most_reynolds = 1e8, least_mach = 0.02, most_mach = 0.95;

/// Largest stable Reynolds number at a Mach number, to a factor 10^(1/8). A run is stable when it
/// reaches its end without core::Divergence; between two tried numbers stability is taken to end
/// once.
LimitRow largest_reynolds(LimitMap const& map, LimitPoint point, int cells);

/// Largest stable Mach number at a Reynolds number, to 2 %.
LimitRow largest_mach(LimitMap const& map, LimitPoint point, int cells);

/// All rows as a CSV file.
std::string csv(std::string const& map, int cells, std::vector<LimitRow> const& rows);

}  // namespace velum::cases
