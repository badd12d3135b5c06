#pragma once
#include <Eigen/SparseCholesky>
#include <cmath>
#include <span>

#include "structure/mass.hpp"
#include "structure/restrained.hpp"
#include "structure/total_stiffness.hpp"

namespace velum::tests {

struct Mode {
  double omega;
  Eigen::VectorXd shape;  ///< largest entry 1
};

/// Slowest free vibration of a body (a Membrane or a Sheet) about its present state, stiffness
/// against lumped mass: inverse iteration from a push along the axis.
template <class Body>
Mode lowest_mode(Body const& body, std::span<structure::Load const> loads)
{
  constexpr int d = Body::dimension;
  auto const K =
      structure::restrained(structure::total_stiffness(body, body.position, loads), body.fixed);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> const ldlt(K);
  Eigen::VectorXd const nodal = structure::lumped_mass(body);
  Eigen::VectorXd mass(body.position.size()), x(body.position.size());
  for (int i = 0; i < mass.size(); ++i) {
    mass[i] = nodal[i / d];
    x[i] = i % d == 0 && !body.fixed[static_cast<std::size_t>(i)] ? 1 + 1e-3 * (i % 7) : 0;
  }
  double squared = 0;
  for (int n = 0; n < 60; ++n) {
    Eigen::VectorXd const next = ldlt.solve(mass.cwiseProduct(x));
    squared = x.dot(mass.cwiseProduct(x)) / x.dot(mass.cwiseProduct(next));
    x = next / next.cwiseAbs().maxCoeff();
  }
  return {std::sqrt(squared), x};
}

}  // namespace velum::tests
