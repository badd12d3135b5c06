#pragma once
#include <span>

#include "structure/modes.hpp"

namespace velum::tests {

struct Mode {
  double omega;
  Eigen::VectorXd shape;  ///< largest entry 1
};

/// Slowest free vibration of a body (a Membrane or a Sheet) about its present state.
template <class Body>
Mode lowest_mode(Body const& body, std::span<structure::Load const> loads)
{
  auto const modes = structure::slowest_modes(body, loads, 1);
  Eigen::Index largest = 0;
  modes.shapes.col(0).cwiseAbs().maxCoeff(&largest);
  return {modes.omega[0], modes.shapes.col(0) / modes.shapes(largest, 0)};
}

}  // namespace velum::tests
