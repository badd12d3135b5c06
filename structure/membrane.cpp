#include "structure/membrane.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cmath>

namespace velum::structure {

Membrane flat_membrane(FlatShape const& shape)
{
  using core::require;
  require(shape.to > shape.from, "a membrane must end farther out than it starts");
  require(shape.symmetry == core::Symmetry::planar || shape.from >= 0,
          "an axisymmetric membrane cannot start at a negative radius");
  require(shape.element_size > 0, "the element size of a membrane must be positive");
  require(shear_modulus(shape.material) > 0, "the shear modulus of a membrane must be positive");
  require(shape.density > 0, "the density of a membrane must be positive");

  double const length = shape.to - shape.from;
  int const elements = std::max(2, static_cast<int>(std::lround(length / shape.element_size)));
  int const nodes = elements + 1;

  Membrane m{.symmetry = shape.symmetry,
             .reference = Eigen::VectorXd(2 * nodes),
             .position = {},
             .velocity = Eigen::VectorXd::Zero(2 * nodes),
             .thickness = Eigen::VectorXd(elements),
             .material = shape.material,
             .density = shape.density,
             .fixed = std::vector<char>(2 * nodes, 0)};
  for (int a = 0; a < nodes; ++a) {
    m.reference[2 * a] = shape.axial;
    m.reference[2 * a + 1] = shape.from + length * a / elements;
  }
  for (int e = 0; e < elements; ++e) {
    m.thickness[e] = shape.thickness(shape.from + length * (e + 0.5) / elements);
    require(m.thickness[e] > 0, "the thickness of a membrane must be positive everywhere");
  }
  m.position = m.reference;
  m.fixed[1] = m.fixed[2 * nodes - 2] = m.fixed[2 * nodes - 1] = 1;
  m.fixed[0] = starts_on_axis(m) ? 0 : 1;
  return m;
}

std::vector<int> nodes_within(Membrane const& m, double radius)
{
  std::vector<int> nodes;
  for (int a = 0; a < node_count(m); ++a)
    if (m.reference[2 * a + 1] <= radius * (1 + 1e-9)) nodes.push_back(a);
  return nodes;
}

}  // namespace velum::structure
