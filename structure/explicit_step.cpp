#include "structure/explicit_step.hpp"

#include "core/check.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"

#include <cmath>

namespace velum::structure {
namespace {

/// Zero matrix that has an entry for every pair of components of one node.
Eigen::SparseMatrix<double> uncoupled_nodes(int nodes)
{
  Triplets entries;
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) entries.emplace_back(2 * a + i, 2 * a + j, 0);
  Eigen::SparseMatrix<double> matrix(2 * nodes, 2 * nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

int place_of(Eigen::SparseMatrix<double> const& matrix, int row, int column)
{
  int k = matrix.outerIndexPtr()[column];
  while (matrix.innerIndexPtr()[k] != row) ++k;
  return k;
}

/// A = M + h (alpha M + beta K0 + Z), all rows and columns.
void fill(ExplicitStepper& s, std::span<Eigen::Matrix2d const> Z, double h)
{
  Eigen::Map<Eigen::ArrayXd>(s.A.valuePtr(), s.A.nonZeros()) =
      h * s.damping.beta * Eigen::Map<Eigen::ArrayXd>(s.K0.valuePtr(), s.K0.nonZeros());
  double* const value = s.A.valuePtr();
  for (int a = 0; a < s.mass.size(); ++a) {
    double const m = s.mass[a] * (1 + h * s.damping.alpha);
    value[s.diagonal[a][0]] += m;
    value[s.diagonal[a][3]] += m;
    if (Z.empty()) continue;
    for (int i = 0; i < 4; ++i) value[s.diagonal[a][i]] += h * Z[a](i % 2, i / 2);
  }
}

/// Moves what prescribed velocities contribute to the right-hand side, then replaces their rows and
/// columns by the identity.
void restrain(ExplicitStepper& s, Membrane const& m)
{
  s.prescribed.setZero();
  for (int column = 0; column < s.A.cols(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator it(s.A, column); it; ++it) {
      int const row = static_cast<int>(it.row());
      if (!m.fixed[row] && !m.fixed[column]) continue;
      if (!m.fixed[row]) s.prescribed[row] -= it.value() * m.velocity[column];
      it.valueRef() = row == column ? 1 : 0;
    }
}

}  // namespace

ExplicitStepper explicit_stepper(Membrane const& m, Rayleigh const& damping)
{
  return explicit_stepper(m, damping, m.reference);
}

ExplicitStepper explicit_stepper(Membrane const& m, Rayleigh const& damping,
                                 Eigen::VectorXd const& state)
{
  int const nodes = node_count(m);
  ExplicitStepper s;
  s.damping = damping;
  s.mass = lumped_mass(m);
  s.K0 = damping.beta > 0 ? damping_stiffness(m, state) : uncoupled_nodes(nodes);
  s.K0.makeCompressed();
  s.A = s.K0;
  s.diagonal.resize(nodes);
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < 4; ++i) s.diagonal[a][i] = place_of(s.A, 2 * a + i % 2, 2 * a + i / 2);
  s.solver = std::make_unique<ExplicitStepper::Solver>();
  s.solver->analyzePattern(s.A);
  s.force = s.rhs = s.prescribed = s.mean = Eigen::VectorXd::Zero(2 * nodes);
  return s;
}

Eigen::VectorXd const& advance(ExplicitStepper& s, Membrane& m, Eigen::VectorXd const& F0,
                               std::span<Eigen::Matrix2d const> Z, double dt, int substeps,
                               std::span<Load const> loads)
{
  double const h = dt / substeps;
  fill(s, Z, h);
  restrain(s, m);
  s.solver->factorize(s.A);
  s.mean.setZero();

  for (int n = 0; n < substeps; ++n) {
    s.force = F0;
    for (auto const& load : loads) load(m.position, s.force, nullptr);
    add_elastic_force(m, m.position, s.force);
    for (int i = 0; i < s.rhs.size(); ++i)
      s.rhs[i] = m.fixed[i] ? m.velocity[i]
                            : s.mass[i / 2] * m.velocity[i] + h * s.force[i] + s.prescribed[i];
    m.velocity = s.solver->solve(s.rhs);
    m.position += h * m.velocity;
    s.mean += m.velocity;
  }
  s.mean /= substeps;
  for (int a = 0; a < node_count(m); ++a)
    if (!std::isfinite(s.mean[2 * a]) || !std::isfinite(s.mean[2 * a + 1]))
      throw core::Divergence("the membrane's motion is no longer finite, first at node " +
                             std::to_string(a) +
                             ": the sub-step may be longer than the stable step, or the force of "
                             "the fluid is not finite");
  return s.mean;
}

}  // namespace velum::structure
