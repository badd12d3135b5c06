#pragma once
#include "structure/internal_force.hpp"
#include "structure/sheet_force.hpp"

#include <span>

namespace velum::structure {

/// Entries of K = -d(elastic force + share * sum of loads)/dx at the positions x, of a Membrane or
/// a Sheet.
template <class Body>
Triplets total_stiffness(Body const& body, Eigen::VectorXd const& x, std::span<Load const> loads,
                         double share = 1)
{
  Triplets entries;
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(x.size());
  for (auto const& load : loads) load(x, unused, &entries);
  for (auto& t : entries) t = {t.row(), t.col(), -share * t.value()};
  add_stiffness(body, x, entries);
  return entries;
}

}  // namespace velum::structure
