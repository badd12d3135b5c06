#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <vector>

namespace velum::structure {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// What acts on the nodes besides elasticity: ADDS its force at the positions x and, where tangent
/// is not null, the entries of dF/dx.   x, force: [2N]
using Load =
    std::function<void(Eigen::VectorXd const& x, Eigen::VectorXd& force, Triplets* tangent)>;

}  // namespace velum::structure
