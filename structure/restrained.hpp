#pragma once
#include "structure/load.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace velum::structure {

/// Square matrix from triplets in which each fixed component has become an equation of its own:
/// row and column zero, diagonal one.
inline Eigen::SparseMatrix<double> restrained(Triplets const& entries,
                                              std::vector<char> const& fixed)
{
  Triplets kept;
  kept.reserve(entries.size() + fixed.size());
  for (auto const& t : entries)
    if (!fixed[t.row()] && !fixed[t.col()]) kept.push_back(t);
  for (int i = 0; i < static_cast<int>(fixed.size()); ++i)
    kept.emplace_back(i, i, fixed[i] ? 1 : 0);
  Eigen::SparseMatrix<double> matrix(fixed.size(), fixed.size());
  matrix.setFromTriplets(kept.begin(), kept.end());
  return matrix;
}

/// Sets the prescribed components of a residual to zero: nothing has to balance there.
inline void drop_fixed(std::vector<char> const& fixed, Eigen::VectorXd& residual)
{
  for (int i = 0; i < residual.size(); ++i)
    if (fixed[i]) residual[i] = 0;
}

}  // namespace velum::structure
