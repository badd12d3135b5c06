#include "structure/implicit_step.hpp"

#include "core/check.hpp"
#include "structure/mass.hpp"
#include "structure/restrained.hpp"
#include "structure/total_stiffness.hpp"

#include <fmt/format.h>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>

namespace velum::structure {
namespace {

constexpr int max_newton = 12;
constexpr double tolerance = 1e-9;
constexpr double smallest_part = 1.0 / 4096;

/// Chung and Hulbert (1993), Eqs. 17, 20 and 25.
struct Weights {
  double alpha_m, alpha_f, gamma, beta;
};

Weights weights(double rho_inf)
{
  double const am = (2 * rho_inf - 1) / (rho_inf + 1), af = rho_inf / (rho_inf + 1);
  return {am, af, 0.5 - am + af, 0.25 * (1 - am + af) * (1 - am + af)};
}

struct State {
  Eigen::VectorXd x, v, a;
};

struct Outcome {
  bool converged = false;
  int iterations = 0;
  double residual = 0;
  int worst_node = 0;
};

Eigen::VectorXd damping_force(ImplicitStepper const& s, Eigen::VectorXd const& v)
{
  Eigen::VectorXd force = s.damping.beta * (s.K0 * v);
  for (int i = 0; i < v.size(); ++i) force[i] += s.damping.alpha * s.mass[i] * v[i];
  return force;
}

Eigen::VectorXd times_mass(ImplicitStepper const& s, Eigen::VectorXd a)
{
  for (int i = 0; i < a.size(); ++i) a[i] *= s.mass[i];
  return a;
}

template <class Body>
void start(ImplicitStepper& s, Body const& m, std::span<Load const> loads)
{
  Eigen::VectorXd force = -damping_force(s, m.velocity);
  for (auto const& load : loads) load(m.position, force, nullptr);
  add_elastic_force(m, m.position, force);
  for (int i = 0; i < force.size(); ++i) force[i] = m.fixed[i] ? 0 : force[i] / s.mass[i];
  s.acceleration = force;
}

/// -d(residual)/dx' of the step equation.
template <class Body>
Eigen::SparseMatrix<double> jacobian(ImplicitStepper const& s, Body const& m,
                                     Eigen::VectorXd const& xf, double dt, Weights const& w,
                                     std::span<Load const> loads)
{
  Triplets entries = total_stiffness(m, xf, loads);
  for (auto& t : entries) t = {t.row(), t.col(), (1 - w.alpha_f) * t.value()};
  double const c = (1 - w.alpha_f) * w.gamma / (w.beta * dt);
  double const inertia = (1 - w.alpha_m) / (w.beta * dt * dt) + c * s.damping.alpha;
  for (int i = 0; i < xf.size(); ++i) entries.emplace_back(i, i, inertia * s.mass[i]);
  for (int k = 0; k < s.K0.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(s.K0, k); it; ++it)
      entries.emplace_back(it.row(), it.col(), c * s.damping.beta * it.value());
  return restrained(entries, m.fixed);
}

/// True where an element's side changed by more than its own length: the step has left the path of
/// the motion, and Newton found another root of the same equation.
template <int d>
bool side_jumped(Eigen::VectorXd const& before, Eigen::VectorXd const& after, int a, int b)
{
  auto const side = [&](Eigen::VectorXd const& x) -> Eigen::Matrix<double, d, 1> {
    return x.segment<d>(d * b) - x.segment<d>(d * a);
  };
  return (side(after) - side(before)).norm() > side(before).norm();
}

bool jumped(Membrane const& m, Eigen::VectorXd const& before, Eigen::VectorXd const& after)
{
  for (int e = 0; e < element_count(m); ++e)
    if (side_jumped<2>(before, after, e, e + 1)) return true;
  return false;
}

bool jumped(Sheet const& s, Eigen::VectorXd const& before, Eigen::VectorXd const& after)
{
  for (auto const& t : s.triangles)
    for (int i = 0; i < 3; ++i)
      if (side_jumped<3>(before, after, t[i], t[(i + 1) % 3])) return true;
  return false;
}

/// The mass of a component is that of its node.
Eigen::VectorXd per_component(Eigen::VectorXd const& nodal, int d)
{
  Eigen::VectorXd mass(d * nodal.size());
  for (int i = 0; i < mass.size(); ++i) mass[i] = nodal[i / d];
  return mass;
}

/// One step of length dt from old; next holds the result where it converged.
template <class Body>
Outcome try_step(ImplicitStepper const& s, Body const& m, State const& old, State& next, double dt,
                 std::span<Load const> loads)
{
  auto const w = weights(s.rho_inf);
  Outcome outcome;
  next = old;
  // The accelerations are the unknowns: small steps then lose no digits. Starting where the old
  // velocity leads keeps a large first acceleration from throwing Newton far away.
  next.a = -(0.5 - w.beta) / w.beta * old.a;
  double const floor = rounding_force(m, old.x);
  double previous = 0;
  for (int iteration = 0;; ++iteration) {
    next.x = old.x + dt * old.v + dt * dt * ((0.5 - w.beta) * old.a + w.beta * next.a);
    next.v = old.v + dt * ((1 - w.gamma) * old.a + w.gamma * next.a);

    Eigen::VectorXd const xf = (1 - w.alpha_f) * next.x + w.alpha_f * old.x;
    Eigen::VectorXd const inertia = times_mass(s, (1 - w.alpha_m) * next.a + w.alpha_m * old.a);
    Eigen::VectorXd const damping = damping_force(s, (1 - w.alpha_f) * next.v + w.alpha_f * old.v);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(xf.size()), elastic = load;
    for (auto const& l : loads) l(xf, load, nullptr);
    add_elastic_force(m, xf, elastic);
    double const scale = std::max({inertia.cwiseAbs().maxCoeff(), damping.cwiseAbs().maxCoeff(),
                                   load.cwiseAbs().maxCoeff(), elastic.cwiseAbs().maxCoeff()});
    Eigen::VectorXd residual = load + elastic - inertia - damping;
    drop_fixed(m.fixed, residual);

    Eigen::Index worst = 0;
    double const now = residual.cwiseAbs().maxCoeff(&worst);
    outcome.worst_node = static_cast<int>(worst) / Body::dimension;
    outcome.residual = scale > 0 ? now / scale : 0;
    outcome.converged = std::isfinite(now) && now <= tolerance * scale + floor;
    bool const hopeless = !std::isfinite(now) || (iteration > 3 && now > 2 * previous);
    if (outcome.converged || hopeless || iteration == max_newton) {
      outcome.converged = outcome.converged && !jumped(m, old.x, next.x);
      return outcome;
    }

    previous = now;
    Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(jacobian(s, m, xf, dt, w, loads));
    if (lu.info() != Eigen::Success) return outcome;
    next.a += lu.solve(residual) / (w.beta * dt * dt);
    ++outcome.iterations;
  }
}

}  // namespace

template <class Body>
ImplicitStepper implicit_stepper(Body const& m, Rayleigh const& damping, double rho_inf)
{
  core::require(rho_inf >= 0 && rho_inf <= 1,
                "the spectral radius at infinite frequency must lie between 0 and 1");
  return {damping,
          rho_inf,
          per_component(lumped_mass(m), Body::dimension),
          damping_stiffness(m, m.reference),
          {}};
}

template <class Body>
ImplicitReport advance(ImplicitStepper& s, Body& m, double dt, std::span<Load const> loads)
{
  if (s.acceleration.size() == 0) start(s, m, loads);
  ImplicitReport report;
  double done = 0, part = 1;  // shares of dt
  State next;
  while (done < 1) {
    part = std::min(part, 1 - done);
    State const old{m.position, m.velocity, s.acceleration};
    auto const outcome = try_step(s, m, old, next, part * dt, loads);
    report.iterations += outcome.iterations;
    if (outcome.converged) {
      m.position = next.x, m.velocity = next.v, s.acceleration = next.a;
      report.residual = std::max(report.residual, outcome.residual);
      ++report.steps;
      done += part;
      part *= 2;
      continue;
    }
    ++report.cut_backs;
    part /= 2;
    if (part < smallest_part)
      throw core::Divergence(fmt::format(
          "the implicit membrane step fails even at {:.1e} of its length {:.3e}: largest residual "
          "{:.1e} of the nodal force at node {}; a load changes too abruptly or the membrane has "
          "no equilibrium near",
          part, dt, outcome.residual, outcome.worst_node));
  }
  return report;
}

template ImplicitStepper implicit_stepper(Membrane const&, Rayleigh const&, double);
template ImplicitStepper implicit_stepper(Sheet const&, Rayleigh const&, double);
template ImplicitReport advance(ImplicitStepper&, Membrane&, double, std::span<Load const>);
template ImplicitReport advance(ImplicitStepper&, Sheet&, double, std::span<Load const>);

}  // namespace velum::structure
