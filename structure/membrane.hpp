#pragma once
#include "core/symmetry.hpp"
#include "core/vec.hpp"
#include "structure/mooney_rivlin.hpp"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace velum::structure {

/// State of an elastic membrane: a chain of N nodes joined by N - 1 straight line elements in the
/// plane (unit depth, plane strain) or in the meridional plane (full ring, hoop stretch included).
/// Nodes are numbered from the axis outwards; each carries x (axial) and y (radial), interleaved.
/// The plus side is right_of(tangent): the +x side of a flat disc. Any consistent set of units.
struct Membrane {
  static constexpr int dimension = 2;  ///< components per node
  core::Symmetry symmetry;
  Eigen::VectorXd reference;  ///< undeformed node positions      [2N]
  Eigen::VectorXd position;   ///< current node positions         [2N]
  Eigen::VectorXd velocity;   ///< current node velocities        [2N]
  Eigen::VectorXd thickness;  ///< undeformed, per element        [N-1]
  MooneyRivlin material;      ///< its energy
  double density;             ///< mass per volume of the solid
  std::vector<char> fixed;    ///< 1: velocity is prescribed      [2N]
};

/// A flat, unloaded membrane along x = axial between two radii (or two heights, planar).
struct FlatShape {
  core::Symmetry symmetry;
  double from;                              ///< reference y of the first node
  double to;                                ///< reference y of the last node
  double element_size;                      ///< wished; rounded so that elements fit
  std::function<double(double)> thickness;  ///< undeformed thickness at reference y
  MooneyRivlin material;
  double density;
  double axial = 0;
};

/// Membrane at rest in the given flat shape; both ends clamped, but a node on the axis of an
/// axisymmetric membrane only keeps y = 0. Throws InputError where a size is not positive.
Membrane flat_membrane(FlatShape const& shape);

inline int node_count(Membrane const& m) { return static_cast<int>(m.reference.size()) / 2; }
inline int element_count(Membrane const& m) { return node_count(m) - 1; }

/// Nodes that lie, undeformed, within a radius of the axis (planar: a height).
std::vector<int> nodes_within(Membrane const& m, double radius);

/// True where the chain starts on the axis of revolution: its mirror image continues it.
inline bool starts_on_axis(Membrane const& m)
{
  return m.symmetry == core::Symmetry::axisymmetric && m.reference[1] == 0;
}

/// The node that is taken for the middle: on the axis, or half-way of a strip or annulus.
inline int middle_node(Membrane const& m) { return starts_on_axis(m) ? 0 : node_count(m) / 2; }

/// Node a of an interleaved vector (positions, velocities, forces).
inline core::Vec2 node(Eigen::VectorXd const& interleaved, int a)
{
  return {interleaved[2 * a], interleaved[2 * a + 1]};
}

}  // namespace velum::structure
