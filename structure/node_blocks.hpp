#pragma once
#include "structure/load.hpp"

#include <vector>

namespace velum::structure {

/// What each node's wall block is: 2 x 2 of a Membrane, 3 x 3 of a Sheet.
template <class Body>
using NodeBlock = Eigen::Matrix<double, Body::dimension, Body::dimension>;

/// Adds a zero for every pair of components of one node, so that a matrix has an entry there.
/// @param d  components per node
inline void add_node_blocks(Triplets& entries, int nodes, int d)
{
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) entries.emplace_back(d * a + i, d * a + j, 0);
}

/// Places of those entries among the values of a compressed matrix, node by node, column by column.
/// [N d d]
inline std::vector<int> node_block_places(Eigen::SparseMatrix<double> const& matrix, int d)
{
  std::vector<int> places;
  for (int column = 0; column < matrix.cols(); ++column)
    for (int i = 0; i < d; ++i) {
      int k = matrix.outerIndexPtr()[column];
      while (matrix.innerIndexPtr()[k] != column - column % d + i) ++k;
      places.push_back(k);
    }
  return places;
}

}  // namespace velum::structure
