#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/node_blocks.hpp"
#include "structure/sheet.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <span>
#include <vector>

namespace velum::structure {

/// The matrix of Newton's method in an implicit step,
///   A = k K + c C + diag(inertia) + Z / h,
/// K the tangent at some position, C the damping's stiffness, Z the wall block of each node. K is
/// kept between steps as long as the caller likes; the rest is set anew for each.
struct NewtonMatrix {
  using Sparse = Eigen::SparseMatrix<double>;
  /// A chain's factors fill nothing as its nodes are numbered.
  using Ldlt = Eigen::SimplicialLDLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>>;
  Sparse K, C, A;             ///< one pattern
  std::vector<int> diagonal;  ///< entries of each node's own block, as in node_block_places()
  Ldlt ldlt;                  ///< of a symmetric chain, its pattern analysed once
  Eigen::SparseLU<Sparse> lu;
  bool by_ldlt = false;   ///< which of the two holds the factors
  bool fresh = true;      ///< whether A of this K has not been built yet
  bool analysed = false;  ///< whether ldlt knows the pattern
  double stiffest = 0;    ///< largest entry of K's diagonal
  double step = 0;        ///< h of the factors at hand, if they hold no wall blocks; else 0
};

/// Sets K from its entries and C; where the pattern is as before, what is known of it is kept.
/// Of a chain, entries between nodes further apart than those that bending joins are left out where
/// their sums are below 1e-6 of the inertia (a spring on a patch): Newton does not feel them, and
/// the factors stay narrow.
/// @param k, inertia  as in factorise(), of the longest step that K is for
template <class Body>
void set_tangent(NewtonMatrix& matrix, Triplets const& K, NewtonMatrix::Sparse const& C, double k,
                 Eigen::VectorXd const& inertia);

/// Builds A and its factors, if those at hand are of another K or step or hold wall blocks; fixed
/// components become equations of their own.
/// @param Z     wall blocks, or empty   [N]
/// @param step  h
/// @return whether A could be factorised
template <class Body>
bool factorise(NewtonMatrix& matrix, double k, double c, Eigen::VectorXd const& inertia,
               std::span<NodeBlock<Body> const> Z, double step, std::vector<char> const& fixed);

/// A^-1 right; after factorise().
Eigen::VectorXd solve(NewtonMatrix const& matrix, Eigen::VectorXd const& right);

}  // namespace velum::structure
