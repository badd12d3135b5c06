#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <span>

namespace velum::structure {

/// Small undamped vibrations about a state: K s = omega^2 M s.
struct Modes {
  Eigen::VectorXd omega;   ///< ascending                    [n]
  Eigen::MatrixXd shapes;  ///< a column each, s^T M s = 1   [2N or 3N, n]
};

/// The n slowest modes of a body (a Membrane or a Sheet) about its position, with the tangents of
/// the loads and the lumped mass; fixed components do not move. Subspace iteration (Bathe and
/// Wilson, J. Eng. Mech. Div. ASCE 98 (1972) 1471).
/// Throws core::Divergence where the state is not stable: K is not positive definite, as that of a
/// flat, unloaded membrane without bending.
template <class Body>
Modes slowest_modes(Body const& body, std::span<Load const> loads, int n);

}  // namespace velum::structure
