#include "structure/damping.hpp"

#include "structure/line_element.hpp"
#include "structure/load.hpp"

#include <Eigen/Eigenvalues>

namespace velum::structure {

Eigen::SparseMatrix<double> damping_stiffness(Membrane const& m, Eigen::VectorXd const& x)
{
  Triplets entries;
  for (int e = 0; e < element_count(m); ++e) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> const modes(element_tangent(m, x, e));
    Eigen::Matrix4d const k = modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() *
                              modes.eigenvectors().transpose();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) entries.emplace_back(2 * e + i, 2 * e + j, k(i, j));
  }
  Eigen::SparseMatrix<double> K0(m.reference.size(), m.reference.size());
  K0.setFromTriplets(entries.begin(), entries.end());
  return K0;
}

}  // namespace velum::structure
