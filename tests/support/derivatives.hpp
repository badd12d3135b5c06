#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

#include "structure/load.hpp"

namespace velum::tests {

/// Components by which a test differences; all of them where a list is not given.
using Components = std::vector<int>;

inline Components all_of(Eigen::VectorXd const& x)
{
  Components all(static_cast<std::size_t>(x.size()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Central difference of f by component i of x.
template <class F>
auto difference(F const& f, Eigen::VectorXd x, int i, double step)
{
  double const here = x[i];
  x[i] = here + step;
  auto const ahead = f(x);
  x[i] = here - step;
  auto const behind = f(x);
  return decltype(f(x))((ahead - behind) / (2 * step));
}

inline Eigen::VectorXd force_of(structure::Load const& load, Eigen::VectorXd const& x)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
  load(x, force, nullptr);
  return force;
}

inline Eigen::MatrixXd tangent_of(structure::Load const& load, Eigen::VectorXd const& x)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
  structure::Triplets entries;
  load(x, force, &entries);
  Eigen::SparseMatrix<double> tangent(x.size(), x.size());
  tangent.setFromTriplets(entries.begin(), entries.end());
  return tangent;
}

/// The elastic force of a body (a Membrane or a Sheet) as a load.
template <class Body>
structure::Load elasticity(Body const& body)
{
  return [&body](Eigen::VectorXd const& x, Eigen::VectorXd& force, structure::Triplets* tangent) {
    add_elastic_force(body, x, force);
    if (!tangent) return;
    structure::Triplets stiffness;
    add_stiffness(body, x, stiffness);
    for (auto const& t : stiffness) tangent->emplace_back(t.row(), t.col(), -t.value());
  };
}

/// Largest entry of a load's tangent less the central differences of its force by and of these
/// components, over the tangent's largest entry.
inline double tangent_error(structure::Load const& load, Eigen::VectorXd const& x, double step,
                            Components const& components)
{
  Eigen::MatrixXd const tangent = tangent_of(load, x);
  double worst = 0;
  for (int j : components) {
    auto const column = difference([&](auto const& at) { return force_of(load, at); }, x, j, step);
    for (int i : components) worst = std::max(worst, std::abs(tangent(i, j) - column[i]));
  }
  return worst / tangent.cwiseAbs().maxCoeff();
}

/// Largest entry of a force plus the gradient of its energy, over the force's largest entry.
template <class Energy>
double gradient_error(Energy const& energy, Eigen::VectorXd const& force, Eigen::VectorXd const& x,
                      double step, Components const& components)
{
  double worst = 0;
  for (int i : components)
    worst = std::max(worst, std::abs(force[i] + difference(energy, x, i, step)));
  return worst / force.cwiseAbs().maxCoeff();
}

}  // namespace velum::tests
