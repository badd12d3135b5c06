#include "structure/explicit_step.hpp"

#include "core/check.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"
#include "structure/sheet_force.hpp"

#include <Eigen/LU>

#include <cmath>
#include <optional>

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

void solve(ExplicitStepper const& s, Eigen::VectorXd const& rhs, Eigen::VectorXd& v)
{
  std::visit([&](auto& solver) { v = solver.solve(rhs); }, *s.solver);
}

/// What the enclosed pressures add to a sub-step, by Woodbury's formula: with B = A_matrix^-1 h A
/// on the free components, v' = v0 + B p' turns the pressures' own equation into
///   (C/h + G + A^T B) p' = C/h p + q - A^T v0,
/// as many unknowns as there are volumes.
struct Enclosing {
  Enclosures& volumes;
  double h;
  Eigen::MatrixXd answer;  // B   [dN][m]
  Eigen::PartialPivLU<Eigen::MatrixXd> small;

  Enclosing(Enclosures& enclosed, ExplicitStepper const& s, std::vector<char> const& fixed,
            double step)
      : volumes(enclosed), h(step), answer(enclosed.area)
  {
    Eigen::VectorXd column, moved;
    for (int k = 0; k < answer.cols(); ++k) {
      column = h * enclosed.area.col(k);
      for (int i = 0; i < column.size(); ++i)
        if (fixed[static_cast<std::size_t>(i)]) column[i] = 0;
      solve(s, column, moved);
      answer.col(k) = moved;
    }
    Eigen::MatrixXd matrix = enclosed.conductance + enclosed.area.transpose() * answer;
    matrix.diagonal() += enclosed.compliance / h;
    small.compute(matrix);
    enclosed.mean = Eigen::VectorXd::Zero(enclosed.pressure.size());
  }

  /// v0 -> v'
  void add(Eigen::VectorXd& v)
  {
    Eigen::VectorXd const given = volumes.compliance.cwiseProduct(volumes.pressure) / h +
                                  volumes.inflow - volumes.area.transpose() * v;
    volumes.pressure = small.solve(given);
    volumes.mean += volumes.pressure;
    v += answer * volumes.pressure;
  }
};

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
                               std::span<Load const> loads, Enclosures* enclosed)
{
  constexpr int d = Body::dimension;
  double const h = dt / substeps;
  fill<d>(s, Z, h);
  restrain(s, m);
  std::visit([&](auto& solver) { solver.factorize(s.A); }, *s.solver);
  s.mean.setZero();
  std::optional<Enclosing> volumes;
  if (enclosed) volumes.emplace(*enclosed, s, m.fixed, h);

  for (int n = 0; n < substeps; ++n) {
    s.force = F0;
    for (auto const& load : loads) load(m.position, s.force, nullptr);
    add_elastic_force(m, m.position, s.force);
    for (int i = 0; i < s.rhs.size(); ++i)
      s.rhs[i] = m.fixed[i] ? m.velocity[i]
                            : s.mass[i / d] * m.velocity[i] + h * s.force[i] + s.prescribed[i];
    solve(s, s.rhs, m.velocity);
    if (volumes) volumes->add(m.velocity);
    m.position += h * m.velocity;
    s.mean += m.velocity;
  }
  s.mean /= substeps;
  if (enclosed) enclosed->mean /= substeps;
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
                                        std::span<Load const>, Enclosures*);
template Eigen::VectorXd const& advance(ExplicitStepper&, Sheet&, Eigen::VectorXd const&,
                                        std::span<Eigen::Matrix3d const>, double, int,
                                        std::span<Load const>, Enclosures*);

}  // namespace velum::structure
