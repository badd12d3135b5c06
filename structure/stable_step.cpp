#include "structure/stable_step.hpp"

#include "structure/total_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::structure {

template <class Body>
double stable_step(Body const& body, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   std::span<Load const> loads, Eigen::VectorXd const& contact_stiffness)
{
  Triplets const entries = total_stiffness(body, x, loads);
  Eigen::SparseMatrix<double> K(x.size(), x.size());
  K.setFromTriplets(entries.begin(), entries.end());
  constexpr int d = Body::dimension;
  double omega2 = 0;
  for (int column = 0; column < K.cols(); ++column) {
    if (body.fixed[static_cast<std::size_t>(column)]) continue;
    int const node = column / d;
    // Of M^-1/2 K M^-1/2: neighbours of very different mass (axis) then weigh alike.
    double sum = contact_stiffness.size() > 0 ? contact_stiffness[node] / mass[node] : 0;
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it)
      if (!body.fixed[static_cast<std::size_t>(it.row())])
        sum += std::abs(it.value()) / std::sqrt(mass[it.row() / d] * mass[node]);
    omega2 = std::max(omega2, sum);
  }
  return omega2 > 0 ? 2 / std::sqrt(omega2) : std::numeric_limits<double>::infinity();
}

template double stable_step(Membrane const&, Eigen::VectorXd const&, Eigen::VectorXd const&,
                            std::span<Load const>, Eigen::VectorXd const&);
template double stable_step(Sheet const&, Eigen::VectorXd const&, Eigen::VectorXd const&,
                            std::span<Load const>, Eigen::VectorXd const&);

int substeps_for(double dt, double stable, double margin)
{
  return std::max(1, static_cast<int>(std::ceil(dt / (margin * stable) - 1e-9)));
}

}  // namespace velum::structure
