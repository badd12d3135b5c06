#pragma once
#include "core/geometry/mesh_topology.hpp"
#include "core/geometry/triangle_tree.hpp"

#include <optional>
#include <vector>

namespace velum::core {

enum class Normals {
  outward,  // out of the solid, everywhere
  inward,   // all the wrong way round
  mixed,    // neighbours or shells disagree
  unknown,  // the surface is not watertight and has no inside
};

/// Which side of a watertight surface is solid. A shell inside an odd number of others is a cavity
/// and has its solid outside; every other shell has it inside.
struct Orientation {
  Normals normals;
  std::vector<bool> inverted;    // for each shell: its normals point into the solid
  std::optional<double> volume;  // of the solid, m3: shells less cavities, unless unknown or mixed
                                 // within a shell. What shells have in common counts twice.
};

Orientation orientation(TriangleMesh const& mesh, MeshTopology const& topology,
                        TriangleTree const& tree);

}  // namespace velum::core
