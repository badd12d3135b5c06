#include "structure/mesh_neighbours.hpp"

#include "core/check.hpp"
#include "core/geometry/mesh_topology.hpp"
#include "core/readable_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace velum::structure {
namespace {

struct Side {
  core::Edge edge;
  int triangle, side;
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The sides of all triangles, those in the same place next to each other.
std::vector<Side> sorted_sides(TriangleMesh const& mesh)
{
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) sides.push_back({core::edge(mesh.triangles[at(t)], k), t, k});
  std::ranges::sort(sides, {}, [](Side const& s) { return std::pair(s.edge.place, s.triangle); });
  return sides;
}

void require_corners(TriangleMesh const& mesh)
{
  auto const points = mesh.points.size() / 3;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    auto const& t = mesh.triangles[i];
    for (int const corner : t)
      if (corner < 0 || corner >= points)
        throw core::InputError(
            fmt::format("Triangle {} of a mesh has the corner {}, but the mesh "
                        "has {} points.",
                        i, corner, points));
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw core::InputError(fmt::format("Triangle {} of a mesh has a corner twice.", i));
  }
}

/// Middle of a side, for a sentence.
std::string place(TriangleMesh const& mesh, int triangle, int side)
{
  auto const& t = mesh.triangles[at(triangle)];
  Eigen::Vector3d const x =
      (node3(mesh.points, t[at(side)]) + node3(mesh.points, t[at((side + 1) % 3)])) / 2;
  return core::readable_place(x[0], x[1], x[2]);
}

[[noreturn]] void refuse_crowded(std::string const& place)
{
  throw core::InputError(
      fmt::format("An edge of the mesh at {} belongs to more than two triangles, and a sheet has "
                  "two sides everywhere: take away what branches off there.",
                  place));
}

[[noreturn]] void refuse_one_sided(std::string const& place)
{
  throw core::InputError(
      fmt::format("The surface of the mesh has one side only, as Moebius's strip has (found at "
                  "{}), and a pressure needs two: cut it open.",
                  place));
}

}  // namespace

std::vector<std::array<Neighbour, 3>> neighbours(TriangleMesh const& mesh)
{
  require_corners(mesh);
  std::array<Neighbour, 3> alone;
  alone.fill({Neighbour::rim, 0, false});
  std::vector across(mesh.triangles.size(), alone);
  auto const sides = sorted_sides(mesh);
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    while (to < sides.size() && sides[to].edge.place == sides[from].edge.place) ++to;
    auto const of = [&](Side const& s) -> Neighbour& { return across[at(s.triangle)][at(s.side)]; };
    if (to - from == 2) {
      auto const &a = sides[from], &b = sides[from + 1];
      bool const same_way = a.edge.rising == b.edge.rising;
      of(a) = {b.triangle, b.side, same_way};
      of(b) = {a.triangle, a.side, same_way};
    }
    for (auto i = from; to - from > 2 && i < to; ++i) of(sides[i]).triangle = Neighbour::crowded;
  }
  return across;
}

int agree_on_sides(TriangleMesh& mesh)
{
  auto const across = neighbours(mesh);
  enum class Visit : char { none, kept, turned };
  std::vector visits(mesh.triangles.size(), Visit::none);
  std::vector<int> front;
  for (int first = 0; first < static_cast<int>(visits.size()); ++first) {
    if (visits[at(first)] != Visit::none) continue;
    visits[at(first)] = Visit::kept;
    front.push_back(first);
    while (!front.empty()) {
      int const t = front.back();
      front.pop_back();
      for (int k = 0; k < 3; ++k) {
        auto const& next = across[at(t)][at(k)];
        if (next.triangle == Neighbour::rim) continue;
        if (next.triangle == Neighbour::crowded) refuse_crowded(place(mesh, t, k));
        bool const turned = (visits[at(t)] == Visit::turned) != next.same_way;
        auto const wanted = turned ? Visit::turned : Visit::kept;
        auto& visit = visits[at(next.triangle)];
        if (visit == Visit::none) {
          visit = wanted;
          front.push_back(next.triangle);
        }
        if (visit != wanted) refuse_one_sided(place(mesh, t, k));
      }
    }
  }
  for (std::size_t t = 0; t < visits.size(); ++t)
    if (visits[t] == Visit::turned) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  return static_cast<int>(std::ranges::count(visits, Visit::turned));
}

}  // namespace velum::structure
