#include "structure/implicit_step.hpp"

#include "core/check.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"
#include "structure/restrained.hpp"

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
  for (int i = 0; i < v.size(); ++i) force[i] += s.damping.alpha * s.mass[i / 2] * v[i];
  return force;
}

Eigen::VectorXd times_mass(ImplicitStepper const& s, Eigen::VectorXd a)
{
  for (int i = 0; i < a.size(); ++i) a[i] *= s.mass[i / 2];
  return a;
}

void start(ImplicitStepper& s, Membrane const& m, std::span<Load const> loads)
{
  Eigen::VectorXd force = -damping_force(s, m.velocity);
  for (auto const& load : loads) load(m.position, force, nullptr);
  add_elastic_force(m, m.position, force);
  for (int i = 0; i < force.size(); ++i) force[i] = m.fixed[i] ? 0 : force[i] / s.mass[i / 2];
  s.acceleration = force;
}

/// -d(residual)/dx' of the step equation.
Eigen::SparseMatrix<double> jacobian(ImplicitStepper const& s, Membrane const& m,
                                     Eigen::VectorXd const& xf, double dt, Weights const& w,
                                     std::span<Load const> loads)
{
  Triplets entries;
  Eigen::VectorXd unused = Eigen::VectorXd::Zero(xf.size());
  for (auto const& load : loads) load(xf, unused, &entries);
  for (auto& t : entries) t = {t.row(), t.col(), -t.value()};
  add_stiffness(m, xf, entries);
  for (auto& t : entries) t = {t.row(), t.col(), (1 - w.alpha_f) * t.value()};
  double const c = (1 - w.alpha_f) * w.gamma / (w.beta * dt);
  double const inertia = (1 - w.alpha_m) / (w.beta * dt * dt) + c * s.damping.alpha;
  for (int i = 0; i < xf.size(); ++i) entries.emplace_back(i, i, inertia * s.mass[i / 2]);
  for (int k = 0; k < s.K0.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(s.K0, k); it; ++it)
      entries.emplace_back(it.row(), it.col(), c * s.damping.beta * it.value());
  return restrained(entries, m.fixed);
}

/// True where an element changed by more than its own length: the step has left the path of the
/// motion, and Newton found another root of the same equation.
bool jumped(Eigen::VectorXd const& before, Eigen::VectorXd const& after)
{
  auto const element = [](Eigen::VectorXd const& x, Eigen::Index i) -> Eigen::Vector2d {
    return x.segment<2>(i + 2) - x.segment<2>(i);
  };
  for (Eigen::Index i = 0; i + 3 < before.size(); i += 2)
    if ((element(after, i) - element(before, i)).norm() > element(before, i).norm()) return true;
  return false;
}

/// One step of length dt from old; next holds the result where it converged.
Outcome try_step(ImplicitStepper const& s, Membrane const& m, State const& old, State& next,
                 double dt, std::span<Load const> loads)
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
    outcome.worst_node = static_cast<int>(worst) / 2;
    outcome.residual = scale > 0 ? now / scale : 0;
    outcome.converged = std::isfinite(now) && now <= tolerance * scale + floor;
    bool const hopeless = !std::isfinite(now) || (iteration > 3 && now > 2 * previous);
    if (outcome.converged || hopeless || iteration == max_newton) {
      outcome.converged = outcome.converged && !jumped(old.x, next.x);
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

ImplicitStepper implicit_stepper(Membrane const& m, Rayleigh const& damping, double rho_inf)
{
  core::require(rho_inf >= 0 && rho_inf <= 1,
                "the spectral radius at infinite frequency must lie between 0 and 1");
  return {damping, rho_inf, lumped_mass(m), damping_stiffness(m, m.reference), {}};
}

ImplicitReport advance(ImplicitStepper& s, Membrane& m, double dt, std::span<Load const> loads)
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

}  // namespace velum::structure
