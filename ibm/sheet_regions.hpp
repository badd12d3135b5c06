#pragma once
#include <span>
#include <vector>

#include "structure/sheet.hpp"

namespace velum::ibm {

/// What lies below a node of a sheet on its seat: fluid that is connected with one or the other
/// side, or the sealed land, on which it touches. A pocket that neither side reaches counts as
/// land.
enum class Below : char { upstream, downstream, land };

/// Nodes that are known to lie over one side or the other, where they do not touch: the rim and the
/// middle of a valve's disc, say.
struct RegionSeeds {
  std::vector<int> upstream, downstream;
};

/// How the contact parts the fluid below a sheet.
struct SheetRegions {
  std::vector<Below> node;       // [N]
  std::vector<double> pressing;  // lambda - k g: the land's edge is where it is zero   [N]
  bool touches = false;
  bool sealed = false;  // touches, and no free way leads from one side to the other
};

/// Regions of a sheet: nodes that do not touch (pressing <= 0) belong together where an edge joins
/// them, and to the side whose seed is among them. That is the way fluid takes where `pressing` is
/// linear in each triangle, so that no mesh, symmetric or not, leaks beside its nodes. Where a way
/// joins both sides, nothing is sealed and all that is free is upstream.
/// @param pressing  contact::pressing() of each node   [N]
SheetRegions find_regions(std::span<structure::Triangle const> triangles,
                          std::vector<double> pressing, RegionSeeds const& seeds);

}  // namespace velum::ibm
