#include "core/geometry/solid_cells.hpp"

#include "core/output/folder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

namespace velum::core {

double cells_in_section(Bounds const& box, CutPlane const& plane, double dx)
{
  double cells = 1;
  for (int const k : {first_in_plane(plane), second_in_plane(plane)})
    cells *= std::ceil(box.hi[k] / dx) - std::floor(box.lo[k] / dx);
  return cells;
}

std::vector<CellRun> solid_cells(SignedDistance<3> const& distance, Bounds const& box,
                                 CutPlane const& plane, double dx)
{
  int const first = first_in_plane(plane), second = second_in_plane(plane);
  auto const below = [&](double x) { return static_cast<long>(std::floor(x / dx)); };
  Vec3 centre;
  centre[plane.axis] = (static_cast<double>(below(plane.at)) + 0.5) * dx;
  std::vector<CellRun> runs;
  for (long j = below(box.lo[second]); j <= below(box.hi[second]); ++j) {
    centre[second] = (static_cast<double>(j) + 0.5) * dx;
    bool open = false;  // the last run ends in the cell before
    for (long i = below(box.lo[first]); i <= below(box.hi[first]); ++i) {
      centre[first] = (static_cast<double>(i) + 0.5) * dx;
      bool const solid = distance(centre) < 0;
      double const left = static_cast<double>(i) * dx, right = static_cast<double>(i + 1) * dx;
      double const low = static_cast<double>(j) * dx, high = static_cast<double>(j + 1) * dx;
      if (solid && !open) runs.push_back({{left, low}, {right, high}});
      if (solid) runs.back().hi[0] = right;
      open = solid;
    }
  }
  return runs;
}

void write_cells(std::filesystem::path const& file, std::vector<CellRun> const& runs,
                 CutPlane const& plane)
{
  constexpr char const* letters = "xyz";
  std::string text = fmt::format("{0} from [m],{0} to [m],{1} from [m],{1} to [m]\n",
                                 letters[first_in_plane(plane)], letters[second_in_plane(plane)]);
  for (auto const& [lo, hi] : runs)
    fmt::format_to(std::back_inserter(text), "{},{},{},{}\n", lo[0], hi[0], lo[1], hi[1]);
  write_atomically(file, text);
}

}  // namespace velum::core
