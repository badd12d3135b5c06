#include "core/check.hpp"
#include "structure/gmsh_records.hpp"
#include "structure/mesh_neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace velum::structure {
namespace {

constexpr int none = -1;

/// Up to three nodes of the file by their place in it; a line has none in the last.
using Nodes = std::array<int, 3>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The nodes of every element, found by their tags, which may be in any order and leave gaps.
std::vector<Nodes> nodes_of_elements(GmshRecords const& records, std::string const& name)
{
  using Entry = std::pair<std::uint64_t, int>;
  std::vector<Entry> by_tag;
  for (auto const& node : records.nodes)
    by_tag.emplace_back(node.tag, static_cast<int>(by_tag.size()));
  std::ranges::sort(by_tag);
  if (auto const twice = std::ranges::adjacent_find(by_tag, {}, &Entry::first);
      twice != by_tag.end())
    throw core::InputError(fmt::format("{}: node {} is given twice.", name, twice->first));

  std::vector<Nodes> nodes;
  for (auto const& element : records.elements) {
    nodes.push_back({none, none, none});
    for (int k = 0; k < element.corners; ++k) {
      auto const tag = element.nodes[at(k)];
      auto const found = std::ranges::lower_bound(by_tag, tag, {}, &Entry::first);
      if (found == by_tag.end() || found->first != tag)
        throw core::InputError(
            fmt::format("{}: element {} has the node {}, which the file does "
                        "not give.",
                        name, element.tag, tag));
      nodes.back()[at(k)] = found->second;
    }
  }
  return nodes;
}

/// The same for the same triangle or line, whichever way round it is given.
Nodes key(Nodes nodes)
{
  std::ranges::sort(nodes);
  return nodes;
}

/// Elements of three nodes that are not given before, the way round that their first group has
/// them; counts those that are given before.
std::vector<Triangle> take_triangles(GmshRecords const& records, std::vector<Nodes> const& nodes,
                                     std::string const& name, GmshMesh& out)
{
  std::vector<std::pair<Nodes, std::size_t>> keys;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (records.elements[i].corners < 3) continue;
    keys.emplace_back(key(nodes[i]), i);
    auto const& k = keys.back().first;
    if (k[0] == k[1] || k[1] == k[2])
      throw core::InputError(fmt::format("{}: element {} is a triangle that has a node twice.",
                                         name, records.elements[i].tag));
  }
  std::ranges::sort(keys);
  std::vector<char> taken(nodes.size(), 0);
  for (std::size_t k = 0; k < keys.size(); ++k)
    taken[keys[k].second] = k == 0 || keys[k].first != keys[k - 1].first;

  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!taken[i]) continue;
    triangles.push_back(nodes[i]);
    auto const groups = records.groups_of.find(records.elements[i].entity);
    bool const reversed = groups != records.groups_of.end() && groups->second.front() < 0;
    if (reversed) std::swap(triangles.back()[1], triangles.back()[2]);
  }
  core::require(!triangles.empty(), name + ": the file holds no triangles.");
  out.repeated = static_cast<int>(keys.size() - triangles.size());
  return triangles;
}

/// Counts the lines, and those of them that are no edge of a triangle.
void count_lines(GmshRecords const& records, std::vector<Nodes> const& nodes,
                 std::vector<Triangle> const& triangles, GmshMesh& out)
{
  std::vector<Nodes> lines, edges;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (records.elements[i].corners == 2) lines.push_back(key(nodes[i]));
  if (lines.empty()) return;
  for (auto const& t : triangles)
    for (int k = 0; k < 3; ++k) edges.push_back(key({none, t[at(k)], t[at((k + 1) % 3)]}));
  std::ranges::sort(edges);
  std::ranges::sort(lines);
  lines.erase(std::ranges::unique(lines).begin(), lines.end());
  out.lines = static_cast<int>(lines.size());
  out.stray_lines = static_cast<int>(std::ranges::count_if(
      lines, [&](Nodes const& line) { return !std::ranges::binary_search(edges, line); }));
}

/// Points of the mesh in the file's order, none for nodes of no triangle.   [nodes]
std::vector<int> take_points(GmshRecords const& records, std::vector<Triangle> const& triangles,
                             double unit, std::string const& name, GmshMesh& out)
{
  std::vector<int> number(records.nodes.size(), none);
  for (auto const& t : triangles)
    for (int const node : t) number[at(node)] = 0;
  int points = 0;
  for (int& n : number)
    if (n != none) n = points++;
  out.unused_nodes = static_cast<int>(number.size()) - points;
  out.mesh.points.resize(3 * points);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == none) continue;
    Eigen::Vector3d const place = unit * records.nodes[i].place;
    if (!place.allFinite())
      throw core::InputError(
          fmt::format("{}: node {} is too far away for metres.", name, records.nodes[i].tag));
    out.mesh.points.segment<3>(3 * number[i]) = place;
  }
  return number;
}

/// The points of each named group of lines or surfaces. @param number  of take_points()
void collect_groups(GmshRecords const& records, std::vector<Nodes> const& nodes,
                    std::vector<int> const& number, std::string const& name, GmshMesh& out)
{
  std::map<GmshTag, std::vector<int>*> points_of;
  for (auto const& [tag, group] : records.names) {
    if (tag.first < 1 || tag.first > 2 || group.empty()) continue;
    auto const [entry, first] = out.groups.try_emplace(group);
    if (!first)
      throw core::InputError(
          fmt::format("{}: two physical groups of lines or surfaces are named "
                      "\"{}\"; give each a name of its own.",
                      name, group));
    points_of[tag] = &entry->second;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    auto const& entity = records.elements[i].entity;
    auto const groups = records.groups_of.find(entity);
    if (groups == records.groups_of.end()) continue;
    for (int const group : groups->second)
      if (auto const points = points_of.find({entity.first, std::abs(group)});
          points != points_of.end())
        for (int const node : nodes[i])
          if (node != none && number[at(node)] != none) points->second->push_back(number[at(node)]);
  }
  for (auto& [group, points] : out.groups) {
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
  }
}

}  // namespace

GmshMesh surface_of(GmshRecords const& records, double unit, std::string const& name)
{
  GmshMesh out;
  out.points = records.points;
  auto const nodes = nodes_of_elements(records, name);
  auto const triangles = take_triangles(records, nodes, name, out);
  count_lines(records, nodes, triangles, out);
  auto const number = take_points(records, triangles, unit, name, out);
  for (auto const& t : triangles)
    out.mesh.triangles.push_back({number[at(t[0])], number[at(t[1])], number[at(t[2])]});
  collect_groups(records, nodes, number, name, out);
  try {
    out.flipped = agree_on_sides(out.mesh);
  } catch (core::InputError const& error) {
    throw core::InputError(fmt::format("{}: {}", name, error.what()));
  }
  return out;
}

}  // namespace velum::structure
