#include "structure/gmsh_records.hpp"

#include <fmt/format.h>

namespace velum::structure {
namespace {

std::uint64_t count(GmshSource& source, char const* what)
{
  return source.value<std::uint64_t>(what);
}

std::uint64_t positive_tag(GmshSource& source, char const* what)
{
  auto const tag = source.value<std::uint64_t>(what);
  if (tag == 0) source.refuse("a tag of a node or element is a whole number above 0.");
  return tag;
}

/// Dimension and tag of the entity of a block.
GmshTag entity(GmshSource& source)
{
  auto const dimension = source.value<std::int32_t>("the dimension of an entity");
  if (dimension < 0 || dimension > 3) source.refuse("the dimension of an entity is 0, 1, 2 or 3.");
  return {dimension, source.value<std::int32_t>("the tag of an entity")};
}

/// Blocks and values of a section, of both together and the range of the tags.
struct Heading {
  std::uint64_t blocks, values;
};

Heading heading(GmshSource& source, char const* what)
{
  source.begin_values();
  Heading const head{count(source, "a number of blocks"), count(source, what)};
  for (int i = 0; i < 2; ++i) count(source, "the smallest or largest tag");
  return head;
}

void require_sum(GmshSource const& source, std::uint64_t promised, std::uint64_t found,
                 char const* what)
{
  if (promised != found)
    source.refuse(
        fmt::format("the section promises {} {}, but its blocks have {}.", promised, what, found));
}

}  // namespace

void read_entities_41(GmshSource& source, GmshRecords& records)
{
  source.begin_values();
  std::uint64_t counts[4];
  for (auto& n : counts) n = count(source, "a number of entities");
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::uint64_t i = 0; i < counts[dimension]; ++i) {
      auto const tag = source.value<std::int32_t>("the tag of an entity");
      for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
        source.value<double>("a bound of an entity");
      std::vector<int> groups;
      for (auto n = count(source, "a number of physical groups"); n > 0; --n) {
        groups.push_back(gmsh_group(source));
      }
      if (!groups.empty()) records.groups_of[{dimension, tag}] = groups;
      if (dimension == 0) continue;
      for (auto n = count(source, "a number of bounding entities"); n > 0; --n)
        source.value<std::int32_t>("the tag of a bounding entity");
    }
  source.expect("$EndEntities");
}

void read_nodes_41(GmshSource& source, GmshRecords& records)
{
  auto const head = heading(source, "the number of nodes");
  for (std::uint64_t block = 0; block < head.blocks; ++block) {
    int const dimension = entity(source).first;
    auto const parametric = source.value<std::int32_t>("0, or 1 for parametric nodes");
    if (parametric != 0 && parametric != 1) source.refuse("a block is parametric (1) or not (0).");
    auto const nodes = count(source, "a number of nodes");
    auto const first = records.nodes.size();
    for (std::uint64_t i = 0; i < nodes; ++i)
      records.nodes.push_back({positive_tag(source, "the tag of a node")});
    for (auto i = first; i < records.nodes.size(); ++i) {
      for (double& x : records.nodes[i].place) x = source.value<double>("a coordinate of a node");
      for (int k = 0; k < parametric * dimension; ++k)
        source.value<double>("a parameter of a node");
    }
  }
  require_sum(source, head.values, records.nodes.size(), "nodes");
  source.expect("$EndNodes");
}

void read_elements_41(GmshSource& source, GmshRecords& records)
{
  auto const head = heading(source, "the number of elements");
  std::uint64_t found = 0;
  for (std::uint64_t block = 0; block < head.blocks; ++block) {
    auto const of = entity(source);
    int const nodes = gmsh_nodes(source, source.value<std::int32_t>("a type of elements"));
    auto const elements = count(source, "a number of elements");
    for (std::uint64_t i = 0; i < elements; ++i, ++found) {
      GmshElement element{positive_tag(source, "the tag of an element"), of, nodes, {}};
      for (int k = 0; k < nodes; ++k)
        element.nodes[static_cast<std::size_t>(k)] = positive_tag(source, "a node of an element");
      if (nodes == 1)
        ++records.points;
      else
        records.elements.push_back(element);
    }
  }
  require_sum(source, head.values, found, "elements");
  source.expect("$EndElements");
}

}  // namespace velum::structure
