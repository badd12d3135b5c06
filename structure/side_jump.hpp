#pragma once
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

namespace velum::structure {

/// True where an element's side changed by more than its own length: the step has left the path of
/// the motion, and Newton found another root of the same equation.
/// @param before, after  positions at the ends of the step   [2N or 3N]
bool jumped(Membrane const& m, Eigen::VectorXd const& before, Eigen::VectorXd const& after);
bool jumped(Sheet const& s, Eigen::VectorXd const& before, Eigen::VectorXd const& after);

}  // namespace velum::structure
