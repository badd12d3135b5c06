#include "cases/app/commands.hpp"
#include "cases/app/length_option.hpp"
#include "core/output/json.hpp"
#include "structure/gmsh.hpp"
#include "structure/mesh_quality.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace velum::cases {
namespace {

using structure::GmshMesh;
using structure::MeshQuality;

/// What else is in the file than the surface, and what was done to that.
std::vector<std::pair<char const*, int>> changes(GmshMesh const& file)
{
  return {{"points left out", file.points},
          {"lines left out", file.lines},
          {"lines along no edge of a triangle", file.stray_lines},
          {"triangles given again left out", file.repeated},
          {"nodes of no triangle left out", file.unused_nodes},
          {"triangles turned over", file.flipped}};
}

std::vector<std::string> warnings(GmshMesh const& file, MeshQuality const& quality)
{
  auto said = structure::warnings(quality);
  if (file.stray_lines > 0)
    said.push_back(fmt::format(
        "{} of the {} lines of the file run along no edge of a triangle: a group of lines has only "
        "those of its points that belong to the surface. In Gmsh, embed the curve in the surface.",
        file.stray_lines, file.lines));
  for (auto const& [name, points] : file.groups)
    if (points.empty())
      said.push_back(fmt::format("the group \"{}\" has no point of the surface.", name));
  return said;
}

void print_text(GmshMesh const& file, MeshQuality const& quality)
{
  fmt::print("{}", structure::text(quality));
  fmt::print("file      {}\n", file.format);
  for (auto const& [what, count] : changes(file))
    if (count > 0) fmt::print("          {}: {}\n", what, count);
  for (auto const& [name, points] : file.groups)
    fmt::print("group     \"{}\": {} {}\n", name, points.size(),
               points.size() == 1 ? "point" : "points");
  for (auto const& sentence : warnings(file, quality)) fmt::print("warning: {}\n", sentence);
}

std::string vector_json(Eigen::Vector3d const& x)
{
  return fmt::format("[{}, {}, {}]", core::json_number(x[0]), core::json_number(x[1]),
                     core::json_number(x[2]));
}

std::string extreme_json(structure::TriangleExtreme const& extreme)
{
  return fmt::format(R"({{"value": {}, "triangle": {}, "place": {}}})",
                     core::json_number(extreme.value), extreme.triangle,
                     vector_json(extreme.place));
}

/// Lengths in metres, angles in degrees.
void print_json(std::string const& name, GmshMesh const& file, MeshQuality const& q)
{
  using core::json_number;
  std::vector<std::pair<std::string, std::string>> const entries{
      {"file", core::json_string(name)},
      {"format", core::json_string(file.format)},
      {"points", fmt::to_string(q.points)},
      {"triangles", fmt::to_string(q.triangles)},
      {"parts", fmt::to_string(q.parts)},
      {"rims", fmt::to_string(q.rims)},
      {"closed", fmt::to_string(q.closed)},
      {"slit_points", fmt::to_string(q.slit_points)},
      {"degenerate", fmt::to_string(q.degenerate)},
      {"box", fmt::format("[{}, {}]", vector_json(q.lo), vector_json(q.hi))},
      {"area", json_number(q.area)},
      {"shortest_edge", json_number(q.shortest_edge)},
      {"mean_edge", json_number(q.mean_edge)},
      {"longest_edge", json_number(q.longest_edge)},
      {"smallest_height", extreme_json(q.smallest_height)},
      {"smallest_angle", extreme_json(q.smallest_angle)},
      {"largest_angle", extreme_json(q.largest_angle)},
      {"mean_shape", json_number(q.mean_shape)},
      {"worst_shape", extreme_json(q.worst_shape)},
      {"size_jump", extreme_json(q.size_jump)}};
  std::string out = "{";
  for (auto const& [key, value] : entries)
    out += fmt::format("{}: {},\n ", core::json_string(key), value);
  auto const list = [&](char const* key, char open, char close, auto const& items,
                        auto const& item) {
    out += fmt::format("{}: {}", core::json_string(key), open);
    char const* separator = "";
    for (auto const& i : items) out += std::exchange(separator, ", ") + item(i);
    out += close;
  };
  auto const counted = [](auto const& entry) {
    return fmt::format("{}: {}", core::json_string(entry.first), entry.second);
  };
  list("changes", '{', '}', changes(file), counted);
  out += ",\n ";
  list("groups", '{', '}', file.groups, [](auto const& group) {
    return fmt::format("{}: {}", core::json_string(group.first), group.second.size());
  });
  out += ",\n ";
  list("warnings", '[', ']', warnings(file, q), core::json_string);
  fmt::print("{}}}\n", out);
}

}  // namespace

void mesh_command(Options const& options)
{
  double const unit = file_unit(options.unit);
  auto const file = structure::read_gmsh(options.mesh, unit);
  auto const quality = structure::mesh_quality(file.mesh);
  if (options.json) return print_json(options.mesh.string(), file, quality);
  fmt::print("{}\n", options.mesh.string());
  print_text(file, quality);
}

}  // namespace velum::cases
