#pragma once
#include "core/vec.hpp"
#include "structure/mooney_rivlin.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace velum::structure {

using Triangle = std::array<int, 3>;

/// Triangles between points of space. The plus side of each is the one from which its corners run
/// counter-clockwise. Any consistent set of units.
struct TriangleMesh {
  Eigen::VectorXd points;           ///< x, y, z interleaved   [3N]
  std::vector<Triangle> triangles;  ///< corners               [T]
};

/// State of a rubber sheet in space: flat triangles of constant strain.
struct Sheet {
  static constexpr int dimension = 3;  ///< components per node
  std::vector<Triangle> triangles;
  Eigen::VectorXd reference;  ///< undeformed node positions        [3N]
  Eigen::VectorXd position;   ///< current node positions           [3N]
  Eigen::VectorXd velocity;   ///< current node velocities          [3N]
  Eigen::VectorXd thickness;  ///< undeformed, per triangle         [T]
  MooneyRivlin material;
  double density;           ///< mass per volume of the solid
  std::vector<char> fixed;  ///< 1: velocity is prescribed          [3N]
};

/// A sheet at rest and unloaded in the shape of a mesh, nothing fixed, of one thickness. Throws
/// InputError where thickness, shear modulus at rest or density is not positive, or a triangle has
/// no area.
Sheet make_sheet(TriangleMesh const& mesh, double thickness, MooneyRivlin const& material,
                 double density);

inline int node_count(Sheet const& s) { return static_cast<int>(s.reference.size()) / 3; }
inline int element_count(Sheet const& s) { return static_cast<int>(s.triangles.size()); }

/// Node a of an interleaved vector of space.
inline Eigen::Vector3d node3(Eigen::VectorXd const& interleaved, int a)
{
  return interleaved.segment<3>(3 * a);
}

/// Holds all three components of a node.
void clamp(Sheet& s, int node);

}  // namespace velum::structure
