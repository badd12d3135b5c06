#include "structure/modes.hpp"

#include "core/check.hpp"
#include "structure/mass.hpp"
#include "structure/restrained.hpp"
#include "structure/total_stiffness.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace velum::structure {

template <class Body>
Modes slowest_modes(Body const& body, std::span<Load const> loads, int n)
{
  auto const size = body.position.size();
  auto const K = restrained(total_stiffness(body, body.position, loads), body.fixed);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> const ldlt(K);
  double const least = ldlt.vectorD().minCoeff();
  if (ldlt.info() != Eigen::Success || !(least > 1e-12 * ldlt.vectorD().maxCoeff()))
    throw core::Divergence(
        "the state has no vibrations: something moves without resistance, as a flat membrane "
        "without bending does, or the state is not stable");
  Eigen::VectorXd const nodal = lumped_mass(body);
  Eigen::VectorXd mass(size);
  for (Eigen::Index i = 0; i < size; ++i) mass[i] = nodal[i / Body::dimension];

  // more columns than modes, so that the last one wanted converges too
  auto const free = std::ranges::count(body.fixed, 0);
  int const columns = static_cast<int>(std::min<std::ptrdiff_t>(std::max(2 * n, n + 8), free));
  core::require(n > 0 && n <= columns, "A body has as many modes as components that may move.");
  Eigen::MatrixXd X(size, columns);
  for (Eigen::Index i = 0; i < size; ++i)
    for (int c = 0; c < columns; ++c)
      X(i, c) = body.fixed[static_cast<std::size_t>(i)] ? 0 : std::cos(double(i * (c + 1)) + c);
  Eigen::VectorXd squared = Eigen::VectorXd::Zero(n);
  for (int iteration = 0; iteration < 200; ++iteration) {
    X = ldlt.solve(mass.asDiagonal() * X).eval();
    for (int c = 0; c < columns; ++c) X.col(c).normalize();
    Eigen::MatrixXd const small_K = X.transpose() * (K * X);
    Eigen::MatrixXd const small_M = X.transpose() * (mass.asDiagonal() * X);
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> const ritz(small_K, small_M);
    X = (X * ritz.eigenvectors()).eval();
    Eigen::VectorXd const next = ritz.eigenvalues().head(n);
    double const change = ((next - squared).array() / next.array()).abs().maxCoeff();
    squared = next;
    if (change < 1e-12) break;
  }
  return {squared.cwiseSqrt(), X.leftCols(n)};
}

template Modes slowest_modes(Membrane const&, std::span<Load const>, int);
template Modes slowest_modes(Sheet const&, std::span<Load const>, int);

}  // namespace velum::structure
