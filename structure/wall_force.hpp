#pragma once
#include "structure/node_blocks.hpp"

#include <span>

namespace velum::structure {

/// Force of the fluid: F0 - Z v at the mean velocity v of a step.
template <class Body>
struct WallForce {
  Eigen::VectorXd const& F0;  // empty: none
  std::span<NodeBlock<Body> const> Z;
};

template <class Body>
void add(WallForce<Body> const& wall, Eigen::VectorXd const& v, Eigen::VectorXd& force)
{
  constexpr int d = Body::dimension;
  if (wall.F0.size() > 0) force += wall.F0;
  for (std::size_t a = 0; a < wall.Z.size(); ++a) {
    auto const k = static_cast<Eigen::Index>(d * a);
    force.segment<d>(k) -= wall.Z[a] * v.segment<d>(k);
  }
}

}  // namespace velum::structure
