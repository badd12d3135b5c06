#include "structure/damping.hpp"

#include "structure/line_element.hpp"
#include "structure/triangle_element.hpp"

#include <Eigen/Eigenvalues>

namespace velum::structure {
namespace {

/// The matrix without its negative eigenvalues.
template <int N>
Eigen::Matrix<double, N, N> non_negative(Eigen::Matrix<double, N, N> const& matrix)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> const modes(matrix);
  return modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).asDiagonal() *
         modes.eigenvectors().transpose();
}

}  // namespace

Eigen::SparseMatrix<double> damping_stiffness(Membrane const& m, Eigen::VectorXd const& x)
{
  Triplets entries;
  for (int e = 0; e < element_count(m); ++e) {
    Eigen::Matrix4d const k = non_negative<4>(element_tangent(m, x, e));
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) entries.emplace_back(2 * e + i, 2 * e + j, k(i, j));
  }
  Eigen::SparseMatrix<double> K0(m.reference.size(), m.reference.size());
  K0.setFromTriplets(entries.begin(), entries.end());
  return K0;
}

Eigen::SparseMatrix<double> damping_stiffness(Sheet const& s, Eigen::VectorXd const& x)
{
  Triplets entries;
  for (int e = 0; e < element_count(s); ++e) {
    Matrix9 const k = non_negative<9>(element_tangent(triangle_element(s, x, e)));
    add_block(entries, s.triangles[static_cast<std::size_t>(e)], k);
  }
  Eigen::SparseMatrix<double> K0(s.reference.size(), s.reference.size());
  K0.setFromTriplets(entries.begin(), entries.end());
  return K0;
}

template <class Body>
Eigen::SparseMatrix<double> damping_stiffness(Body const& m, Eigen::VectorXd const& x,
                                              std::span<Load const> elastic)
{
  Triplets entries;
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(m.reference.size());
  for (auto const& load : elastic) load(m.reference, unused, &entries);
  for (auto& t : entries) t = {t.row(), t.col(), -t.value()};
  Eigen::SparseMatrix<double> K(unused.size(), unused.size());
  K.setFromTriplets(entries.begin(), entries.end());
  return damping_stiffness(m, x) + K;
}

template Eigen::SparseMatrix<double> damping_stiffness(Membrane const&, Eigen::VectorXd const&,
                                                       std::span<Load const>);
template Eigen::SparseMatrix<double> damping_stiffness(Sheet const&, Eigen::VectorXd const&,
                                                       std::span<Load const>);

}  // namespace velum::structure
