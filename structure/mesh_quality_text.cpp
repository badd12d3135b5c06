#include "core/readable_length.hpp"
#include "structure/mesh_quality.hpp"

#include <fmt/format.h>

#include <numbers>

namespace velum::structure {
namespace {

// Degrees. Small angles cost steps and conditioning (Shewchuk, What is a good linear finite
// element?, 2002), large ones accuracy: the error of the gradient has no bound towards 180 (Babuska
// and Aziz, SIAM J. Numer. Anal. 13 (1976), doi:10.1137/0713021).
constexpr double least_angle = 15, largest_angle = 150;
constexpr double most_jump = 2, most_spread = 20;  // of neighbours' sizes, of all edges

std::string counted(int count, char const* one, char const* many)
{
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string where(TriangleExtreme const& e)
{
  return fmt::format("triangle {} at {}", e.triangle,
                     core::readable_place(e.place[0], e.place[1], e.place[2]));
}

std::string rims(MeshQuality const& q)
{
  return q.closed ? "closed" : fmt::format("open, with {}", counted(q.rims, "rim", "rims"));
}

/// How much higher an equilateral triangle of the mean edge is than the flattest triangle.
double loss_of_step(MeshQuality const& q)
{
  return q.mean_edge * std::numbers::sqrt3 / 2 / q.smallest_height.value;
}

void warn_of_surface(MeshQuality const& q, std::vector<std::string>& said)
{
  if (q.degenerate > 0)
    said.push_back(fmt::format("{} no area, the first being {}; a sheet cannot be made of them.",
                               counted(q.degenerate, "triangle has", "triangles have"),
                               where(q.worst_shape)));
  if (q.crowded_edges > 0)
    said.push_back(
        fmt::format("{} to more than two triangles, and a sheet has two sides everywhere: take "
                    "away what branches off.",
                    counted(q.crowded_edges, "edge belongs", "edges belong")));
  if (q.flipped_edges > 0)
    said.push_back(
        fmt::format("{} between triangles that disagree about the plus side, so that a pressure "
                    "pushes them in opposite directions: turn some over.",
                    counted(q.flipped_edges, "edge lies", "edges lie")));
  if (q.slit_points > 0)
    said.push_back(
        fmt::format("{} in the place of another: if the sheet shall be whole there, "
                    "merge them (in Gmsh: Coherence, or BooleanFragments, before meshing).",
                    counted(q.slit_points, "point of the rim lies", "points of the rim lie")));
  if (q.parts > 1)
    said.push_back(
        fmt::format("the mesh has {} parts that no edge joins: each moves on its own.", q.parts));
}

void warn_of_shape(MeshQuality const& q, std::vector<std::string>& said)
{
  if (q.degenerate > 0) return;  // angles of nothing
  if (q.smallest_angle.value < least_angle)
    said.push_back(fmt::format(
        "the smallest angle is {:.1f} degrees, below {}, of {}: the stable step of the explicit "
        "scheme falls with the smallest height, {}, up to about {:.1f} times below that of even "
        "triangles (a row of thin ones; one alone costs less), and the solver's matrix is worse "
        "conditioned; strains suffer only where an angle comes near 180.",
        q.smallest_angle.value, least_angle, where(q.smallest_angle),
        core::readable_length(q.smallest_height.value), loss_of_step(q)));
  if (q.largest_angle.value > largest_angle)
    said.push_back(fmt::format(
        "the largest angle is {:.1f} degrees, above {}, of {}: the error of the strain grows "
        "without bound towards 180; move the point in the flat corner, or mesh anew.",
        q.largest_angle.value, largest_angle, where(q.largest_angle)));
  if (q.size_jump.value > most_jump)
    said.push_back(
        fmt::format("{} is {:.1f} times as large as a neighbour: beyond {} the coarse "
                    "side limits the accuracy of the fine one; grade more gently.",
                    where(q.size_jump), q.size_jump.value, most_jump));
  if (q.longest_edge > most_spread * q.shortest_edge)
    said.push_back(fmt::format(
        "the longest edge is {:.3g} times the shortest, {}: one step serves the whole sheet, and "
        "the smallest triangle sets it.",
        q.longest_edge / q.shortest_edge, core::readable_length(q.shortest_edge)));
}

}  // namespace

std::string text(MeshQuality const& q)
{
  Eigen::Vector3d const size = q.hi - q.lo;
  auto const unit = core::readable_unit(size.maxCoeff());
  std::string text =
      fmt::format("surface   {} on {} in {}; {}\n", counted(q.triangles, "triangle", "triangles"),
                  counted(q.points, "point", "points"), counted(q.parts, "part", "parts"), rims(q));
  text += fmt::format(
      "size      {:.4g} x {:.4g} x {:.4g} {}, from {} to {}\n"
      "          area {:.4g} {}2\n",
      size[0] / unit.metres, size[1] / unit.metres, size[2] / unit.metres, unit.name,
      core::readable_place(q.lo[0], q.lo[1], q.lo[2]),
      core::readable_place(q.hi[0], q.hi[1], q.hi[2]), q.area / (unit.metres * unit.metres),
      unit.name);
  text += fmt::format("edges     {} to {}, mean {}; smallest height {}\n",
                      core::readable_length(q.shortest_edge), core::readable_length(q.longest_edge),
                      core::readable_length(q.mean_edge),
                      core::readable_length(q.smallest_height.value));
  text += fmt::format("angles    {:.1f} to {:.1f} degrees\n", q.smallest_angle.value,
                      q.largest_angle.value);
  text += fmt::format(
      "shape     mean {:.3f}, worst {:.3f} of {} (1: equilateral, 0: no area)\n"
      "          neighbours differ in size by a factor of {:.3g} at most\n",
      q.mean_shape, q.worst_shape.value, where(q.worst_shape), q.size_jump.value);
  return text;
}

std::vector<std::string> warnings(MeshQuality const& q)
{
  std::vector<std::string> said;
  warn_of_surface(q, said);
  warn_of_shape(q, said);
  return said;
}

}  // namespace velum::structure
