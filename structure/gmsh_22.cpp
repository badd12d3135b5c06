#include "structure/gmsh_records.hpp"

#include <cstdlib>

namespace velum::structure {
namespace {

std::uint64_t positive_tag(GmshSource& source, char const* what)
{
  auto const tag = source.value<std::int32_t>(what);
  if (tag <= 0) source.refuse("a tag of a node or element is a whole number above 0.");
  return static_cast<std::uint64_t>(tag);
}

/// What follows the type of an element and the number of its tags.
void read_element(GmshSource& source, GmshRecords& records, std::uint64_t tag, int nodes, int tags)
{
  int group = 0;
  for (int i = 0; i < tags; ++i) {
    if (i == 0)
      group = std::abs(gmsh_group(source));
    else
      source.value<std::int32_t>("a tag of an element");
  }
  GmshElement element{tag, {nodes - 1, group}, nodes, {}};
  for (int i = 0; i < nodes; ++i)
    element.nodes[static_cast<std::size_t>(i)] = positive_tag(source, "a node of an element");
  if (nodes == 1) {
    ++records.points;
    return;
  }
  if (group != 0) records.groups_of[element.entity] = {group};
  records.elements.push_back(element);
}

}  // namespace

void read_nodes_22(GmshSource& source, GmshRecords& records)
{
  auto const count = source.number("the number of nodes");
  source.begin_values();
  for (std::int64_t i = 0; i < count; ++i) {
    GmshNode node{positive_tag(source, "the tag of a node")};
    for (double& x : node.place) x = source.value<double>("a coordinate of a node");
    records.nodes.push_back(node);
  }
  source.expect("$EndNodes");
}

void read_elements_22(GmshSource& source, GmshRecords& records)
{
  auto const count = source.number("the number of elements");
  source.begin_values();
  for (std::int64_t i = 0; i < count;) {
    std::uint64_t tag = 0;
    std::int32_t together = 1;  // elements under one heading
    if (!source.binary) tag = positive_tag(source, "the tag of an element");
    int const nodes = gmsh_nodes(source, source.value<std::int32_t>("the type of an element"));
    if (source.binary) together = source.value<std::int32_t>("a number of elements");
    if (together <= 0 || together > count - i)
      source.refuse("a heading has none of the elements that are left, or more than these.");
    auto const tags = source.value<std::int32_t>("the number of tags of an element");
    if (tags < 0) source.refuse("the number of tags of an element is 0 or more.");
    for (std::int32_t k = 0; k < together; ++k, ++i) {
      if (source.binary) tag = positive_tag(source, "the tag of an element");
      read_element(source, records, tag, nodes, tags);
    }
  }
  source.expect("$EndElements");
}

}  // namespace velum::structure
