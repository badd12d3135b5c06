#include "structure/static_solve.hpp"

#include "core/check.hpp"
#include "structure/mass.hpp"
#include "structure/restrained.hpp"
#include "structure/total_stiffness.hpp"

#include <fmt/format.h>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::structure {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// Out-of-balance force under a share of the loads, and the size of the forces in balance.
struct Balance {
  Eigen::VectorXd residual;
  double scale;
};

template <class Body>
Balance balance(Body const& m, std::span<Load const> loads, double share)
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(m.position.size()), elastic = load;
  for (auto const& l : loads) l(m.position, load, nullptr);
  load *= share;
  add_elastic_force(m, m.position, elastic);
  Balance b{load + elastic, 0};
  drop_fixed(m.fixed, b.residual);
  b.scale = std::max(load.cwiseAbs().maxCoeff(), elastic.cwiseAbs().maxCoeff());
  return b;
}

/// K = -d(elastic + share * loads)/dx of the free components.
template <class Body>
Matrix tangent(Body const& m, std::span<Load const> loads, double share)
{
  return restrained(total_stiffness(m, m.position, loads, share), m.fixed);
}

/// Factors of a matrix: of its symmetric part, which tell whether it is definite. They solve with
/// the whole by iterative refinement where little of it is not symmetric, as under a pressure that
/// is not the same everywhere; where that is too slow, the whole is factored.
struct Factors {
  explicit Factors(Matrix const& matrix) : whole(matrix)
  {
    Matrix const transposed = matrix.transpose();
    ldlt.compute(0.5 * (matrix + transposed));
    definite = ldlt.info() == Eigen::Success && ldlt.vectorD().minCoeff() > 0;
  }

  Eigen::VectorXd solve(Eigen::VectorXd const& right) const
  {
    constexpr int sweeps = 12;  // in which refinement is quicker than other factors
    Eigen::VectorXd x = ldlt.solve(right), missed = right - whole * x;
    double const enough = 1e-11 * right.norm();
    for (int n = 0; n < sweeps && missed.norm() > enough; ++n) {
      x += ldlt.solve(missed);
      missed = right - whole * x;
    }
    return missed.norm() <= enough ? x : Eigen::SparseLU<Matrix>(whole).solve(right);
  }

  Matrix const& whole;
  Eigen::SimplicialLDLT<Matrix> ldlt;
  bool definite;
};

double extent(Membrane const& m)
{
  return norm(node(m.reference, node_count(m) - 1) - node(m.reference, 0));
}
double extent(Sheet const& s)
{
  auto const points = s.reference.reshaped(3, node_count(s));
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm() / 2;
}

/// Force that the rounding of the positions alone leaves on a node: stiff bending or contact cannot
/// balance better.
double rounding(Matrix const& K, Eigen::VectorXd const& x)
{
  Eigen::VectorXd rows = Eigen::VectorXd::Zero(K.rows());
  for (int k = 0; k < K.outerSize(); ++k)
    for (Matrix::InnerIterator it(K, k); it; ++it) rows[it.row()] += std::abs(it.value());
  return std::numeric_limits<double>::epsilon() * rows.maxCoeff() * x.cwiseAbs().maxCoeff();
}

struct Relaxation {
  bool converged = false;
  bool burst = false;
  int iterations = 0;
  Balance last;
};

/// Pseudo-transient Newton under a constant share of the load, from the position of m: implicit
/// Euler steps of M dx/dtau = residual(x) with shift = 1 / dtau, each solved only as far as needed.
template <class Body>
Relaxation relax(Body& m, std::span<Load const> loads, double share, Matrix const& mass,
                 double reach, StaticOptions const& options)
{
  constexpr int max_newton = 8;   // contact that opens or closes needs a few
  constexpr double enough = 0.3;  // part of the residual a step may leave unexplained
  Relaxation r;
  r.last = balance(m, loads, share);
  double const elastic_floor = rounding_force(m, m.position);
  double const burst = std::max(options.largest_stretch, 2 * largest_stretch(m, m.position));
  Eigen::VectorXd const inertia = mass.diagonal();
  double shift = r.last.residual.cwiseAbs().cwiseQuotient(inertia).maxCoeff() / reach;

  while (r.iterations < options.max_iterations) {
    Matrix K = tangent(m, loads, share);
    // A neutral direction (flat, unloaded) is no instability: hence the tiny shift.
    double const tiny = 1e-10 * K.diagonal().cwiseQuotient(inertia).maxCoeff();
    double const now = r.last.residual.cwiseAbs().maxCoeff();
    if (!std::isfinite(now)) return r;
    double const floor = std::max(elastic_floor, rounding(K, m.position));
    if (now <= options.tolerance * r.last.scale + floor) {
      Matrix const nudged = K + tiny * mass;
      r.converged = Factors(nudged).definite;
      return r;
    }
    Eigen::VectorXd const start = m.position;
    double const size = r.last.residual.norm();
    Eigen::VectorXd open = r.last.residual;  // residual of the implicit Euler step
    Balance next;
    double missed = 0;
    int newton = 0;
    bool accepted = false;
    for (; newton < max_newton && !accepted; ++newton, ++r.iterations) {
      if (newton > 0) K = tangent(m, loads, share);
      Matrix const J = K + shift * mass;
      Factors const factors(J);
      if (!factors.definite) break;
      m.position += factors.solve(open);
      next = balance(m, loads, share);
      open = next.residual - shift * (mass * (m.position - start));
      missed = open.norm() / size;
      accepted = missed < enough;
      if (!std::isfinite(missed)) break;
    }
    if (!accepted) {
      m.position = start;
      shift = std::max(5 * shift, 10 * tiny);
      ++r.iterations;
      continue;
    }
    r.last = next;
    if (newton == 1) shift *= std::max(missed, 1e-4);
    r.burst = largest_stretch(m, m.position) > burst;
    if (r.burst) return r;
  }
  return r;
}

template <class Body>
[[noreturn]] void give_up(Body const& m, Relaxation const& r, double carried, double tried)
{
  Eigen::Index worst = 0;
  r.last.residual.cwiseAbs().maxCoeff(&worst);
  double const stretch = largest_stretch(m, m.position);
  auto const cause =
      r.burst || stretch > 1.5
          ? fmt::format(
                "the stretch reached {:.2f}: the limit point of inflation is passed (a "
                "clamped neo-Hookean disc carries at most p a / (mu H) = 1.879); make the "
                "membrane thicker or stiffer, or lower the pressure",
                stretch)
          : std::string(
                "the membrane may be compressed in its plane, where it buckles, or "
                "it slips off its contact");
  throw core::Divergence(
      fmt::format("no stable static equilibrium beyond {:.4f} of the load (tried {:.4f}); largest "
                  "residual {:.1e} of the nodal force at node {} of {}; {}",
                  carried, tried, r.last.residual.cwiseAbs().maxCoeff() / r.last.scale,
                  worst / Body::dimension, node_count(m), cause));
}

}  // namespace

template <class Body>
StaticReport static_solve(Body& m, std::span<Load const> loads, StaticOptions const& options)
{
  Eigen::VectorXd const nodal = lumped_mass(m);
  Triplets entries;
  for (int i = 0; i < m.position.size(); ++i)
    entries.emplace_back(i, i, nodal[i / Body::dimension]);
  Matrix mass(m.position.size(), m.position.size());
  mass.setFromTriplets(entries.begin(), entries.end());
  double const reach = 0.05 * extent(m);

  StaticReport report;
  Eigen::VectorXd good = m.position;
  double carried = 0, step = 1;
  while (carried < 1) {
    double const share = std::min(1.0, carried + step);
    auto const r = relax(m, loads, share, mass, reach, options);
    report.iterations += r.iterations;
    if (r.converged) {
      ++report.load_steps;
      report.residual = r.last.scale > 0 ? r.last.residual.cwiseAbs().maxCoeff() / r.last.scale : 0;
      carried = share;
      step *= 2;
      good = m.position;
      continue;
    }
    step /= 2;
    if (step < options.min_load_step) give_up(m, r, carried, share);
    m.position = good;
  }
  for (int i = 0; i < m.velocity.size(); ++i)
    if (!m.fixed[i]) m.velocity[i] = 0;
  return report;
}

template StaticReport static_solve(Membrane&, std::span<Load const>, StaticOptions const&);
template StaticReport static_solve(Sheet&, std::span<Load const>, StaticOptions const&);

}  // namespace velum::structure
