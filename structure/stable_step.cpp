#include "structure/stable_step.hpp"

#include "structure/line_element.hpp"
#include "structure/total_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::structure {

double stable_step(Membrane const& m, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   Eigen::VectorXd const& contact_stiffness)
{
  double omega2 = 0;
  // Row of M^-1/2 K M^-1/2: neighbours of very different mass (axis) then weigh alike.
  auto const scale = [&](int dof) { return 1 / std::sqrt(mass[dof / 2]); };
  int const elements = element_count(m);
  Eigen::Matrix4d before = Eigen::Matrix4d::Zero(), after;
  for (int a = 0; a <= elements; ++a) {
    after = a < elements ? element_tangent(m, x, a) : Eigen::Matrix4d::Zero();
    double const contact = contact_stiffness.size() > 0 ? contact_stiffness[a] : 0;
    for (int i = 0; i < 2; ++i) {
      int const row = 2 * a + i;
      if (m.fixed[row]) continue;
      double sum = 0;
      for (int j = 0; j < 2; ++j) {
        auto const entry = [&](int dof, double k) {
          if (!m.fixed[dof]) sum += std::abs(k) * scale(dof);
        };
        if (a > 0) entry(row - i - 2 + j, before(2 + i, j));
        entry(row - i + j, before(2 + i, 2 + j) + after(i, j));
        if (a < elements) entry(row - i + 2 + j, after(i, 2 + j));
      }
      omega2 = std::max(omega2, scale(row) * (sum + contact * scale(row)));
    }
    before = after;
  }
  return omega2 > 0 ? 2 / std::sqrt(omega2) : std::numeric_limits<double>::infinity();
}

double stable_step(Sheet const& s, Eigen::VectorXd const& mass, Eigen::VectorXd const& x,
                   std::span<Load const> loads)
{
  Triplets const entries = total_stiffness(s, x, loads);
  Eigen::SparseMatrix<double> K(x.size(), x.size());
  K.setFromTriplets(entries.begin(), entries.end());
  double omega2 = 0;
  for (int column = 0; column < K.cols(); ++column) {
    if (s.fixed[static_cast<std::size_t>(column)]) continue;
    double sum = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, column); it; ++it)
      if (!s.fixed[static_cast<std::size_t>(it.row())])
        sum += std::abs(it.value()) / std::sqrt(mass[it.row() / 3] * mass[column / 3]);
    omega2 = std::max(omega2, sum);
  }
  return omega2 > 0 ? 2 / std::sqrt(omega2) : std::numeric_limits<double>::infinity();
}

int substeps_for(double dt, double stable, double margin)
{
  return std::max(1, static_cast<int>(std::ceil(dt / (margin * stable) - 1e-9)));
}

}  // namespace velum::structure
