#pragma once
#include "structure/mesh_neighbours.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace velum::tests {

/// One of the four ways to write a mesh.
struct MshFormat {
  int version;  // 22 or 41
  bool binary;
};

inline constexpr std::array msh_formats{MshFormat{22, false}, MshFormat{22, true},
                                        MshFormat{41, false}, MshFormat{41, true}};

/// A file in the making: values are text in lines, or bytes as in memory.
struct MshBytes {
  bool binary;
  std::string bytes;

  template <class T>
  void value(T v)
  {
    char raw[sizeof v];
    std::memcpy(raw, &v, sizeof v);
    binary ? bytes.append(raw, sizeof v) : bytes.append(fmt::format("{} ", v));
  }
  void end_of_line()
  {
    if (!binary) bytes += '\n';
  }
  void text(std::string const& line) { bytes += line + '\n'; }
  void begin(MshFormat const& format)
  {
    text("$MeshFormat");
    text(fmt::format("{} {:d} 8", format.version == 22 ? "2.2" : "4.1", binary));
    if (binary) value(std::int32_t{1}), bytes += '\n';
    text("$EndMeshFormat");
  }
  /// $End..., which follows on a line of its own
  void close(std::string const& section) { text((binary ? "\n$End" : "$End") + section); }
};

/// A mesh as a program would save it: with a node that belongs to nothing, a point, the edges of
/// the rim as lines of the group "rim" (1, 7), and the triangles as the group "sheet" (2, 3).
struct MshContents {
  structure::TriangleMesh mesh;
  std::vector<std::uint64_t> tags;  // of the points, which stand in the file in their order
  std::int32_t sheet = 3;           // in version 4.1 negative: the other way round

  explicit MshContents(structure::TriangleMesh m)
      : mesh(std::move(m)), tags(static_cast<std::size_t>(mesh.points.size() / 3))
  {
    std::iota(tags.begin(), tags.end(), std::uint64_t{2});
  }

  std::vector<std::array<int, 2>> rim() const
  {
    std::vector<std::array<int, 2>> edges;
    auto const across = structure::neighbours(mesh);
    for (std::size_t t = 0; t < across.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (across[t][k].triangle == structure::Neighbour::rim)
          edges.push_back({mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]});
    return edges;
  }
  std::uint64_t tag(int point) const { return tags[static_cast<std::size_t>(point)]; }
};

inline constexpr std::uint64_t lone_tag = 1;

template <class Corners>
void put_element(MshBytes& out, MshContents const& contents, MshFormat const& format, int tag,
                 std::array<std::int32_t, 2> const& kind_and_group, Corners const& corners)
{
  bool const old = format.version == 22;
  auto const [kind, group] = kind_and_group;
  if (old && out.binary)
    for (int const v : {kind, 1, 2, tag, group, 1}) out.value(std::int32_t{v});
  else if (old)
    for (int const v : {tag, kind, 2, group, 1}) out.value(std::int32_t{v});
  else
    out.value(static_cast<std::uint64_t>(tag));
  for (int const point : corners) {
    auto const node = contents.tag(point);
    old ? out.value(static_cast<std::int32_t>(node)) : out.value(node);
  }
  out.end_of_line();
}

inline void put_entities(MshBytes& out, MshContents const& contents)
{
  out.text("$Entities");
  for (std::uint64_t const n : {1, 1, 1, 0}) out.value(n);
  out.end_of_line();
  for (int dimension = 0; dimension < 3; ++dimension) {
    out.value(std::int32_t{1});
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) out.value(0.0);
    out.value(std::uint64_t{dimension > 0});
    if (dimension > 0) out.value(dimension == 1 ? std::int32_t{7} : contents.sheet);
    if (dimension > 0) out.value(std::uint64_t{1}), out.value(std::int32_t{-1});
    out.end_of_line();
  }
  out.close("Entities");
}

inline void put_nodes(MshBytes& out, MshContents const& contents, MshFormat const& format)
{
  bool const old = format.version == 22;
  auto const& x = contents.mesh.points;
  std::uint64_t const count = contents.tags.size() + 1;
  auto const place = [&](int point) {
    for (int i = 0; i < 3; ++i) out.value(point < 0 ? -9.0 : x[3 * point + i]);
    out.end_of_line();
  };
  auto const tag_of = [&](int point) { return point < 0 ? lone_tag : contents.tag(point); };
  int const points = static_cast<int>(contents.tags.size());
  out.text("$Nodes");
  if (old) out.text(fmt::to_string(count));
  for (int point = -1; old && point < points; ++point) {
    out.value(static_cast<std::int32_t>(tag_of(point)));
    place(point);
  }
  if (!old) {
    for (std::uint64_t const n : {std::uint64_t{2}, count, lone_tag, std::uint64_t{9999}})
      out.value(n);
    out.end_of_line();
    for (auto const& [first, last] : {std::pair{-1, 0}, std::pair{0, points}}) {
      for (int const v : {first < 0 ? 0 : 2, 1, 0}) out.value(std::int32_t{v});
      out.value(static_cast<std::uint64_t>(last - first));
      out.end_of_line();
      for (int point = first; point < last; ++point) out.value(tag_of(point)), out.end_of_line();
      for (int point = first; point < last; ++point) place(point);
    }
  }
  out.close("Nodes");
}

inline void put_elements(MshBytes& out, MshContents const& contents, MshFormat const& format)
{
  auto const rim = contents.rim();
  auto const& triangles = contents.mesh.triangles;
  auto const count = 1 + rim.size() + triangles.size();
  out.text("$Elements");
  auto const block = [&](int dimension, int kind, std::size_t n) {
    if (format.version == 22) return;
    for (int const v : {dimension, 1, kind}) out.value(std::int32_t{v});
    out.value(std::uint64_t{n});
    out.end_of_line();
  };
  if (format.version == 22) {
    out.text(fmt::to_string(count));
  } else {
    for (std::uint64_t const n : {std::size_t{3}, count, std::size_t{1}, count}) out.value(n);
    out.end_of_line();
  }
  int tag = 0;
  block(0, 15, 1);
  put_element(out, contents, format, ++tag, {15, 0}, std::array{0});
  block(1, 1, rim.size());
  for (auto const& edge : rim) put_element(out, contents, format, ++tag, {1, 7}, edge);
  block(2, 2, triangles.size());
  for (auto const& t : triangles) put_element(out, contents, format, ++tag, {2, 3}, t);
  out.close("Elements");
}

inline std::string msh(MshContents const& contents, MshFormat const& format)
{
  MshBytes out{format.binary, ""};
  out.begin(format);
  out.text("$PhysicalNames\n2\n1 7 \"rim\"\n2 3 \"sheet\"\n$EndPhysicalNames");
  if (format.version == 41) put_entities(out, contents);
  put_nodes(out, contents, format);
  put_elements(out, contents, format);
  return out.bytes;
}

}  // namespace velum::tests
