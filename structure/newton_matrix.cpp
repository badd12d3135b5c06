#include "structure/newton_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace velum::structure {
namespace {

using Sparse = NewtonMatrix::Sparse;

constexpr int bending_reach = 2;        // nodes
constexpr double far_share = 1e-6;      // of the inertia: what may be left out
constexpr double symmetric_to = 1e-12;  // of the largest entry

/// Without the entries far off the diagonal of a chain, where none of their sums weighs anything.
Triplets narrowed(Triplets const& entries, double k, Eigen::VectorXd const& inertia)
{
  auto const far = [](Eigen::Triplet<double> const& t) {
    return std::abs(t.row() / 2 - t.col() / 2) > bending_reach;
  };
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(inertia.size());
  for (auto const& t : entries)
    if (far(t)) sum[t.row()] += k * std::abs(t.value());
  if ((sum.array() > far_share * inertia.array()).any()) return entries;
  Triplets near;
  near.reserve(entries.size());
  for (auto const& t : entries)
    if (!far(t)) near.push_back(t);
  return near;
}

bool same_pattern(Sparse const& a, Sparse const& b)
{
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Rows and columns of fixed components become those of the identity.
void restrain(Sparse& A, std::vector<char> const& fixed)
{
  for (int column = 0; column < A.cols(); ++column)
    for (Sparse::InnerIterator it(A, column); it; ++it)
      if (fixed[static_cast<std::size_t>(column)] || fixed[static_cast<std::size_t>(it.row())])
        it.valueRef() = it.row() == column ? 1 : 0;
}

bool is_symmetric(Sparse const& A)
{
  Sparse const transposed = A.transpose();
  if (!same_pattern(A, transposed)) return false;
  Eigen::Map<Eigen::ArrayXd const> const a(A.valuePtr(), A.nonZeros());
  Eigen::Map<Eigen::ArrayXd const> const b(transposed.valuePtr(), A.nonZeros());
  return (a - b).abs().maxCoeff() <= symmetric_to * a.abs().maxCoeff();
}

/// K + share of C, on the pattern of both and of the nodes' own blocks.
Sparse joined(Triplets entries, Sparse const& C, double share, int nodes, int d)
{
  add_node_blocks(entries, nodes, d);
  for (int column = 0; column < C.outerSize(); ++column)
    for (Sparse::InnerIterator it(C, column); it; ++it)
      entries.emplace_back(it.row(), it.col(), share * it.value());
  Sparse matrix(C.rows(), C.cols());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

template <class Body>
void set_tangent(NewtonMatrix& s, Triplets const& entries, Sparse const& C, double k,
                 Eigen::VectorXd const& inertia)
{
  constexpr int d = Body::dimension;
  constexpr bool chain = d == 2;
  int const nodes = static_cast<int>(inertia.size()) / d;
  Sparse K = joined(chain ? narrowed(entries, k, inertia) : entries, C, 0, nodes, d);
  bool const known = s.K.rows() > 0 && same_pattern(K, s.K);
  s.K.swap(K);
  s.stiffest = s.K.diagonal().cwiseAbs().maxCoeff();
  s.fresh = true;
  if (known) return;
  Triplets zeros;
  for (int column = 0; column < s.K.outerSize(); ++column)
    for (Sparse::InnerIterator it(s.K, column); it; ++it) zeros.emplace_back(it.row(), it.col(), 0);
  s.C = joined(zeros, C, 1, nodes, d);
  s.A = s.K;
  s.diagonal = node_block_places(s.A, d);
  s.analysed = false;
}

template <class Body>
bool factorise(NewtonMatrix& s, double k, double c, Eigen::VectorXd const& inertia,
               std::span<NodeBlock<Body> const> Z, double step, std::vector<char> const& fixed)
{
  constexpr int d = Body::dimension;
  if (!s.fresh && Z.empty() && s.step == step) return true;
  s.step = 0;
  auto const values = [](Sparse& m) {
    return Eigen::Map<Eigen::ArrayXd>(m.valuePtr(), m.nonZeros());
  };
  values(s.A) = k * values(s.K) + c * values(s.C);
  double* const value = s.A.valuePtr();
  for (int i = 0; i < inertia.size(); ++i)
    value[s.diagonal[static_cast<std::size_t>(d * i + i % d)]] += inertia[i];
  for (std::size_t a = 0; a < Z.size(); ++a)
    for (std::size_t i = 0; i < d * d; ++i)
      value[s.diagonal[d * d * a + i]] += Z[a](i % d, i / d) / step;
  restrain(s.A, fixed);
  if (s.fresh) s.by_ldlt = d == 2 && is_symmetric(s.A);
  s.fresh = false;
  if (s.by_ldlt) {
    if (!s.analysed) s.ldlt.analyzePattern(s.A);
    s.analysed = true;
    s.ldlt.factorize(s.A);
    // without pivots only a positive definite matrix is safe
    s.by_ldlt = s.ldlt.info() == Eigen::Success && s.ldlt.vectorD().minCoeff() > 0;
  }
  if (!s.by_ldlt) s.lu.compute(s.A);
  bool const done = s.by_ldlt || s.lu.info() == Eigen::Success;
  if (done && Z.empty()) s.step = step;
  return done;
}

Eigen::VectorXd solve(NewtonMatrix const& s, Eigen::VectorXd const& right)
{
  if (s.by_ldlt) return s.ldlt.solve(right);
  return s.lu.solve(right);
}

template void set_tangent<Membrane>(NewtonMatrix&, Triplets const&, Sparse const&, double,
                                    Eigen::VectorXd const&);
template void set_tangent<Sheet>(NewtonMatrix&, Triplets const&, Sparse const&, double,
                                 Eigen::VectorXd const&);
template bool factorise<Membrane>(NewtonMatrix&, double, double, Eigen::VectorXd const&,
                                  std::span<Eigen::Matrix2d const>, double,
                                  std::vector<char> const&);
template bool factorise<Sheet>(NewtonMatrix&, double, double, Eigen::VectorXd const&,
                               std::span<Eigen::Matrix3d const>, double, std::vector<char> const&);

}  // namespace velum::structure
