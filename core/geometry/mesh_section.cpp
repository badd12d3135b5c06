#include "core/geometry/mesh_section.hpp"

#include "core/geometry/mesh_topology.hpp"
#include "core/output/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <unordered_map>

namespace velum::core {
namespace {

/// A triangle's part of the section, between two of its edges.
struct Piece {
  Edge from, to;
};

std::optional<Piece> piece(TriangleMesh const& mesh, Triangle const& triangle,
                           CutPlane const& plane)
{
  std::array<bool, 3> above{};
  for (std::size_t k = 0; k < 3; ++k)
    above[k] = mesh.vertices[static_cast<std::size_t>(triangle[k])][plane.axis] >= plane.at;
  if (above[0] == above[1] && above[1] == above[2]) return {};
  // The solid is on the left from the edge that goes down to the edge that comes up again.
  Piece result{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (above[k] == above[(k + 1) % 3]) continue;
    (above[k] ? result.from : result.to) = edge(triangle, static_cast<int>(k));
  }
  return result;
}

/// Where an edge crosses the plane; the same to the last bit for both of its triangles.
Vec2 point_on(TriangleMesh const& mesh, Edge const& edge, CutPlane const& plane)
{
  auto const [low, high] = vertices_of(edge);
  Vec3 const a = mesh.vertices[static_cast<std::size_t>(low)];
  Vec3 const b = mesh.vertices[static_cast<std::size_t>(high)];
  double const s = (plane.at - a[plane.axis]) / (b[plane.axis] - a[plane.axis]);
  Vec3 const p = a + s * (b - a);
  return {p[first_in_plane(plane)], p[second_in_plane(plane)]};
}

/// Joins pieces that end on the same edge, each used once.
class Chain {
 public:
  explicit Chain(std::vector<Piece> const& pieces) : pieces_(pieces), used_(pieces.size(), false)
  {
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (Edge const& end : {pieces[k].from, pieces[k].to}) at_[end.place].push_back(k);
  }

  /// Edges of the line through piece k; none when it is already part of another.
  std::vector<Edge> line(std::size_t k)
  {
    if (used_[k]) return {};
    used_[k] = true;
    std::vector<Edge> edges{pieces_[k].from, pieces_[k].to};
    extend(edges);
    if (edges.front().place == edges.back().place) return edges;
    std::reverse(edges.begin(), edges.end());  // an open line goes on at its other end too
    extend(edges);
    std::reverse(edges.begin(), edges.end());
    return edges;
  }

 private:
  void extend(std::vector<Edge>& edges)
  {
    while (auto const next = unused_at(edges.back().place)) {
      used_[*next] = true;
      Piece const& piece = pieces_[*next];
      edges.push_back(piece.from.place == edges.back().place ? piece.to : piece.from);
      if (edges.back().place == edges.front().place) return;
    }
  }

  std::optional<std::size_t> unused_at(std::uint64_t place) const
  {
    for (std::size_t const k : at_.at(place))
      if (!used_[k]) return k;
    return {};
  }

  std::vector<Piece> const& pieces_;
  std::vector<bool> used_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<Polyline> section(TriangleMesh const& mesh, CutPlane const& plane)
{
  std::vector<Piece> pieces;
  for (auto const* part : {&mesh.triangles, &mesh.needles})
    for (auto const& triangle : *part)
      if (auto const found = piece(mesh, triangle, plane)) pieces.push_back(*found);

  Chain chain(pieces);
  std::vector<Polyline> lines;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    Polyline line;
    for (Edge const& edge : chain.line(k)) line.push_back(point_on(mesh, edge, plane));
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

void write_section(std::filesystem::path const& file, std::vector<Polyline> const& lines,
                   CutPlane const& plane)
{
  constexpr char const* letters = "xyz";
  std::string text = fmt::format("line [1],{} [m],{} [m]\n", letters[first_in_plane(plane)],
                                 letters[second_in_plane(plane)]);
  for (std::size_t k = 0; k < lines.size(); ++k)
    for (Vec2 const& p : lines[k])
      fmt::format_to(std::back_inserter(text), "{},{},{}\n", k, p[0], p[1]);
  write_atomically(file, text);
}

}  // namespace velum::core
