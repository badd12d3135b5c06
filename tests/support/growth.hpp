#pragma once
#include <Eigen/Dense>
#include <functional>
#include <random>
#include <vector>

#include "tests/support/flow.hpp"

namespace velum::tests {

/// A map whose small departures from rest are taken as linear: populations, and whatever else
/// moves.
using Advance = std::function<Eigen::VectorXd(Eigen::VectorXd const&)>;

/// Departure from rest at which the program's own step is asked for its linear part, and half the
/// difference of two opposite departures taken: what is left is of its third order. Far below the
/// viscosities, a velocity near which changes the rates of central moments; populations are stored
/// less their rest values, so that so little is not rounded away.
constexpr double small_departure = 1e-11;

struct Growth {
  double per_step;  // largest modulus of an eigenvalue of one step
  double residual;  // of its eigenvector, over `steps` steps; relative
  double unsure;    // what the residual leaves open of per_step: residual / steps
};

/// Largest eigenvalue of a step by Arnoldi's method (W. E. Arnoldi, Q. Appl. Math. 9 (1951) 17) on
/// the map of `steps` steps at once, begun anew with its leading vector until that is found to
/// 1e-5, `rounds` times at most. One step alone would not do: it is far from normal, and what its
/// walls make larger for a while is no growth.
/// @param advance  `steps` steps
inline Growth growth(Advance const& advance, Eigen::Index size, int steps, int rounds)
{
  constexpr int vectors = 24;
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  Eigen::VectorXd start = Eigen::VectorXd::NullaryExpr(size, [&] { return normal(engine); });
  Growth found{0, 1, 1};
  start = advance(advance(start));  // what decays at once is gone
  for (int round = 0; round < rounds; ++round) {
    Eigen::MatrixXd basis(size, vectors + 1);
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(vectors + 1, vectors);
    basis.col(0) = start.normalized();
    int used = 0;
    for (int k = 0; k < vectors; ++k) {
      Eigen::VectorXd next = advance(basis.col(k));
      for (int twice = 0; twice < 2; ++twice)
        for (int l = 0; l <= k; ++l) {
          double const part = basis.col(l).dot(next);
          h(l, k) += part;
          next -= part * basis.col(l);
        }
      used = k + 1;
      h(k + 1, k) = next.norm();
      if (h(k + 1, k) < 1e-13) break;
      basis.col(k + 1) = next / h(k + 1, k);
    }
    Eigen::EigenSolver<Eigen::MatrixXd> const solver(h.topLeftCorner(used, used));
    Eigen::Index leading = 0;
    double const modulus = solver.eigenvalues().cwiseAbs().maxCoeff(&leading);
    Eigen::VectorXcd const y = solver.eigenvectors().col(leading);
    double const residual = std::abs(y[used - 1]) * h(used, used - 1) / modulus;
    found = {std::pow(modulus, 1.0 / steps), residual, residual / steps};
    if (found.residual < 1e-5) break;
    start = basis.leftCols(used) * (y.real() + y.imag());
  }
  return found;
}

/// What of a flow can move: the populations of its cells with fluid, over the roots of their
/// weights, so that the norm is that which streaming keeps.
template <class Real, class L, class Stored>
struct Departures {
  Flow<Real, L, Stored>& flow;
  std::vector<int> cells;

  explicit Departures(Flow<Real, L, Stored>& of) : flow(of)
  {
    for (long c = 0; c < flow.fluid.cells(); ++c)
      if (flow.fluid.active(flow.fluid.cell_of(c))) cells.push_back(flow.fluid.cell_of(c));
  }
  Eigen::Index size() const { return Eigen::Index(cells.size()) * L::Q; }
  void set(Eigen::VectorXd const& v, double scale) const
  {
    Eigen::Index at = 0;
    for (int c : cells)
      for (int d = 0; d < L::Q; ++d)
        flow.fluid.f.set_outgoing(d, c, Real(scale * std::sqrt(L::w(d)) * v[at++]));
  }
  Eigen::VectorXd get(double scale) const
  {
    Eigen::VectorXd v(size());
    Eigen::Index at = 0;
    for (int c : cells)
      for (int d = 0; d < L::Q; ++d)
        v[at++] = double(flow.fluid.f.outgoing(d, c)) / (scale * std::sqrt(L::w(d)));
    return v;
  }
};

/// Growth of small motions of a flow about rest.
template <class Real, class L, class Stored>
Growth growth(Flow<Real, L, Stored>& flow, int steps = 200, int rounds = 6)
{
  Departures<Real, L, Stored> const departures(flow);
  return growth(
      [&](Eigen::VectorXd const& v) {
        double const scale = small_departure / v.cwiseAbs().maxCoeff();
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(v.size());
        for (double sign : {1.0, -1.0}) {
          departures.set(v, sign * scale);
          for (int t = 0; t < steps; ++t) step(flow);
          sum += departures.get(sign * scale) / 2;
        }
        return sum;
      },
      departures.size(), steps, rounds);
}

}  // namespace velum::tests
