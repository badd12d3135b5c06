#pragma once
#include "structure/gmsh.hpp"
#include "structure/gmsh_source.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace velum::structure {

/// What a MSH file says of a surface, the same for every version, in the file's own tags.

struct GmshNode {
  std::uint64_t tag;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< in the file's unit
};

/// Dimension and tag of a physical group or of a geometrical entity.
using GmshTag = std::pair<int, int>;

struct GmshElement {
  std::uint64_t tag;
  GmshTag entity;  ///< whose physical groups are its own
  int corners;     ///< 2: line, 3: triangle
  std::array<std::uint64_t, 3> nodes;
};

struct GmshRecords {
  std::vector<GmshNode> nodes;
  std::vector<GmshElement> elements;
  int points = 0;
  std::map<GmshTag, std::string> names;  ///< of physical groups
  /// Tags of the physical groups of an entity; negative where the group has it the other way round.
  std::map<GmshTag, std::vector<int>> groups_of;
};

/// Nodes of an element of this type of Gmsh: 1 of a point (15), 2 of a line (1), 3 of a triangle
/// (2). Refuses any other with its name and what to do.
int gmsh_nodes(GmshSource const& source, std::int32_t type);

/// Tag of a physical group, negative where the group has an entity the other way round.
std::int32_t gmsh_group(GmshSource& source);

/// Sections of version 2.2, from behind their opening word to behind their closing one. There the
/// first tag of an element is its physical group, which stands for its entity.
void read_nodes_22(GmshSource& source, GmshRecords& records);
void read_elements_22(GmshSource& source, GmshRecords& records);

/// Those of version 4.1.
void read_entities_41(GmshSource& source, GmshRecords& records);
void read_nodes_41(GmshSource& source, GmshRecords& records);
void read_elements_41(GmshSource& source, GmshRecords& records);

/// The surface of the records. @param name  the file's, for the sentences
GmshMesh surface_of(GmshRecords const& records, double unit, std::string const& name);

}  // namespace velum::structure
