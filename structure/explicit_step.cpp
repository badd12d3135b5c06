#include "structure/explicit_step.hpp"

#include "core/check.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"
#include "structure/sheet_force.hpp"

#include <cmath>

namespace velum::structure {
namespace {

/// Zero matrix that couples the components of each node alone.
Eigen::SparseMatrix<double> uncoupled_nodes(int nodes, int d)
{
  Triplets entries;
  add_node_blocks(entries, nodes, d);
  Eigen::SparseMatrix<double> matrix(d * nodes, d * nodes);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// A = M + h (alpha M + beta K0 + Z), all rows and columns.
template <int d>
void fill(ExplicitStepper& s, std::span<Eigen::Matrix<double, d, d> const> Z, double h)
{
  Eigen::Map<Eigen::ArrayXd>(s.A.valuePtr(), s.A.nonZeros()) =
      h * s.damping.beta * Eigen::Map<Eigen::ArrayXd>(s.K0.valuePtr(), s.K0.nonZeros());
  double* const value = s.A.valuePtr();
  for (int a = 0; a < s.mass.size(); ++a) {
    double const m = s.mass[a] * (1 + h * s.damping.alpha);
    int const* const place = &s.diagonal[static_cast<std::size_t>(d * d * a)];
    for (int i = 0; i < d; ++i) value[place[(d + 1) * i]] += m;
    if (Z.empty()) continue;
    for (int i = 0; i < d * d; ++i)
      value[place[i]] += h * Z[static_cast<std::size_t>(a)](i % d, i / d);
  }
}

/// Moves what prescribed velocities contribute to the right-hand side, then replaces their rows and
/// columns by the identity.
template <class Body>
void restrain(ExplicitStepper& s, Body const& m)
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

template <class Body>
ExplicitStepper explicit_stepper(Body const& m, Rayleigh const& damping)
{
  return explicit_stepper(m, damping, m.reference);
}

template <class Body>
ExplicitStepper explicit_stepper(Body const& m, Rayleigh const& damping,
                                 Eigen::VectorXd const& state, std::span<Load const> elastic)
{
  constexpr int d = Body::dimension;
  int const nodes = node_count(m);
  ExplicitStepper s;
  s.damping = damping;
  s.mass = lumped_mass(m);
  s.K0 = damping.beta > 0 ? damping_stiffness(m, state, elastic) : uncoupled_nodes(nodes, d);
  s.K0.makeCompressed();
  s.A = s.K0;
  s.diagonal = node_block_places(s.A, d);
  s.solver = std::make_unique<ExplicitStepper::Solver>();
  if (d == 3 && damping.beta > 0) s.solver->emplace<1>();
  std::visit([&](auto& solver) { solver.analyzePattern(s.A); }, *s.solver);
  s.force = s.rhs = s.prescribed = s.mean = Eigen::VectorXd::Zero(d * nodes);
  return s;
}

template <class Body>
Eigen::VectorXd const& advance(ExplicitStepper& s, Body& m, Eigen::VectorXd const& F0,
                               std::span<NodeBlock<Body> const> Z, double dt, int substeps,
                               std::span<Load const> loads)
{
  constexpr int d = Body::dimension;
  double const h = dt / substeps;
  fill<d>(s, Z, h);
  restrain(s, m);
  std::visit([&](auto& solver) { solver.factorize(s.A); }, *s.solver);
  s.mean.setZero();

  for (int n = 0; n < substeps; ++n) {
    s.force = F0;
    for (auto const& load : loads) load(m.position, s.force, nullptr);
    add_elastic_force(m, m.position, s.force);
    for (int i = 0; i < s.rhs.size(); ++i)
      s.rhs[i] = m.fixed[i] ? m.velocity[i]
                            : s.mass[i / d] * m.velocity[i] + h * s.force[i] + s.prescribed[i];
    std::visit([&](auto& solver) { m.velocity = solver.solve(s.rhs); }, *s.solver);
    m.position += h * m.velocity;
    s.mean += m.velocity;
  }
  s.mean /= substeps;
  for (int a = 0; a < node_count(m); ++a)
    if (!s.mean.segment<d>(d * a).allFinite())
      throw core::Divergence("the membrane's motion is no longer finite, first at node " +
                             std::to_string(a) +
                             ": the sub-step may be longer than the stable step, or the force of "
                             "the fluid is not finite");
  return s.mean;
}

template ExplicitStepper explicit_stepper(Membrane const&, Rayleigh const&);
template ExplicitStepper explicit_stepper(Sheet const&, Rayleigh const&);
template ExplicitStepper explicit_stepper(Membrane const&, Rayleigh const&, Eigen::VectorXd const&,
                                          std::span<Load const>);
template ExplicitStepper explicit_stepper(Sheet const&, Rayleigh const&, Eigen::VectorXd const&,
                                          std::span<Load const>);
template Eigen::VectorXd const& advance(ExplicitStepper&, Membrane&, Eigen::VectorXd const&,
                                        std::span<Eigen::Matrix2d const>, double, int,
                                        std::span<Load const>);
template Eigen::VectorXd const& advance(ExplicitStepper&, Sheet&, Eigen::VectorXd const&,
                                        std::span<Eigen::Matrix3d const>, double, int,
                                        std::span<Load const>);

}  // namespace velum::structure
