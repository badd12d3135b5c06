#include "structure/implicit_step.hpp"

#include "core/check.hpp"
#include "structure/enclosed_newton.hpp"
#include "structure/generalised_alpha.hpp"
#include "structure/mass.hpp"
#include "structure/restrained.hpp"
#include "structure/side_jump.hpp"
#include "structure/total_stiffness.hpp"
#include "structure/wall_force.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::structure {
namespace {

constexpr int max_newton = 12;
constexpr double tolerance = 1e-9;
constexpr double smallest_part = 1.0 / 4096;
constexpr int few = 4;  // corrections: what a new tangent costs

struct Outcome {
  bool converged = false;
  int iterations = 0;
  double residual = 0;
  int worst_node = 0;
};

/// Whether more than a few corrections are needed yet where the last one took the residual from
/// previous to now: a new tangent is cheaper then.
bool is_slow(double now, double previous, double allowed)
{
  return now >= previous || std::log(allowed / now) < few * std::log(now / previous);
}

double largest(Eigen::VectorXd const& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0; }

Eigen::VectorXd damping_force(ImplicitStepper const& s, Eigen::VectorXd const& v)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(v.size());
  if (s.damping.beta > 0) force = s.damping.beta * (s.K0 * v);
  for (int i = 0; i < v.size(); ++i) force[i] += s.damping.alpha * s.mass[i] * v[i];
  return force;
}

Eigen::VectorXd times_mass(ImplicitStepper const& s, Eigen::VectorXd a)
{
  for (int i = 0; i < a.size(); ++i) a[i] *= s.mass[i];
  return a;
}

/// First acceleration, damped by Z as a step of length dt would: where Z stops the body within a
/// step, the acceleration of the instant would ring for long.
template <class Body>
void start(ImplicitStepper& s, Body const& m, WallForce<Body> const& wall,
           EnclosedNewton const& enclosed, double dt, std::span<Load const> loads)
{
  constexpr int d = Body::dimension;
  Eigen::VectorXd force = -damping_force(s, m.velocity);
  add(wall, m.velocity, force);
  if (enclosed.volumes) force += enclosed.volumes->area * enclosed.volumes->pressure;
  for (auto const& load : loads) load(m.position, force, nullptr);
  add_elastic_force(m, m.position, force);
  for (int a = 0; a < node_count(m); ++a) {
    NodeBlock<Body> mass = s.mass[d * a] * NodeBlock<Body>::Identity();
    if (!wall.Z.empty()) mass += dt * wall.Z[static_cast<std::size_t>(a)];
    force.segment<d>(d * a) = mass.inverse() * force.segment<d>(d * a);
  }
  drop_fixed(m.fixed, force);
  s.acceleration = force;
}

/// Factors of -d(residual)/dx' of the step equation; with a tangent at xf, or with that at hand.
template <class Body>
bool factorise(ImplicitStepper& s, Body const& m, WallForce<Body> const& wall,
               Eigen::VectorXd const* xf, double dt, Weights const& w, std::span<Load const> loads)
{
  double const k = 1 - w.alpha_f, c = k * w.gamma / (w.beta * dt);
  Eigen::VectorXd const inertia =
      ((1 - w.alpha_m) / (w.beta * dt * dt) + c * s.damping.alpha) * s.mass;
  if (xf) set_tangent<Body>(*s.newton, total_stiffness(m, *xf, loads), s.K0, k, inertia);
  return factorise<Body>(*s.newton, k, c * s.damping.beta, inertia, wall.Z, dt, m.fixed);
}

/// The mass of a component is that of its node.
Eigen::VectorXd per_component(Eigen::VectorXd const& nodal, int d)
{
  Eigen::VectorXd mass(d * nodal.size());
  for (int i = 0; i < mass.size(); ++i) mass[i] = nodal[i / d];
  return mass;
}

/// One step of length dt from old; next holds the result where it converged. A tangent serves for
/// as long as its corrections converge well, from step to step.
template <class Body>
Outcome try_step(ImplicitStepper& s, Body const& m, WallForce<Body> const& wall,
                 EnclosedNewton& enclosed, State const& old, State& next, double dt,
                 std::span<Load const> loads)
{
  auto const w = weights(s.rho_inf);
  Outcome outcome;
  next = old;
  double const served = dt <= s.tangent_step ? s.tangent_step : 0;
  bool keeps = true;  // the tangent that the step began with
  s.tangent_step = 0;
  // The accelerations are the unknowns: small steps then lose no digits. Starting where the old
  // velocity leads keeps a large first acceleration from throwing Newton far away; where steps are
  // short the acceleration hardly changes.
  next.a = served > 0 ? old.a : Eigen::VectorXd(-(0.5 - w.beta) / w.beta * old.a);
  // of a thick plate of short elements bending weighs far more than stretching; residuals were seen
  // to stay at 0.08 of a relative rounding there
  double const turned = std::numeric_limits<double>::epsilon() / 4 * s.newton->stiffest;
  double const rounding = std::max(rounding_force(m, old.x), turned * largest(old.x));
  double previous = 0;
  for (int iteration = 0;; ++iteration) {
    Eigen::VectorXd const mean = follow(old, next, dt, w);
    Eigen::VectorXd const xf = (1 - w.alpha_f) * next.x + w.alpha_f * old.x;
    Eigen::VectorXd const inertia = times_mass(s, (1 - w.alpha_m) * next.a + w.alpha_m * old.a);
    Eigen::VectorXd const damping = damping_force(s, (1 - w.alpha_f) * next.v + w.alpha_f * old.v);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(xf.size()), elastic = load;
    add(wall, mean, load);
    push(enclosed, mean, dt, load);
    for (auto const& l : loads) l(xf, load, nullptr);
    add_elastic_force(m, xf, elastic);
    double const scale = std::max(
        {largest(inertia), largest(damping), largest(load), largest(elastic), largest(wall.F0)});
    Eigen::VectorXd residual = load + elastic - inertia - damping;
    drop_fixed(m.fixed, residual);

    Eigen::Index worst = 0;
    double const now = residual.cwiseAbs().maxCoeff(&worst);
    outcome.worst_node = static_cast<int>(worst) / Body::dimension;
    outcome.residual = scale > 0 ? now / scale : 0;
    double const allowed = tolerance * scale;
    // without a correction the acceleration would stay, and its error add up over the steps
    outcome.converged =
        iteration == 0 ? now <= std::min(allowed, rounding) : now <= allowed + rounding;
    bool const hopeless = !std::isfinite(now) || (iteration > 3 && now > 2 * previous);
    if (outcome.converged || hopeless || iteration == max_newton) {
      if (outcome.converged && iteration > 0) {  // what is left is not left to add up either
        next.a += correction(enclosed, *s.newton, residual) / (w.beta * dt * dt);
        push(enclosed, follow(old, next, dt, w), dt, load);
      }
      outcome.converged = outcome.converged && !jumped(m, old.x, next.x);
      if (outcome.converged && keeps && iteration <= few)
        s.tangent_step = served > 0 || iteration == 0 ? served : dt;
      return outcome;
    }

    bool const slow = iteration > 0 && is_slow(now, previous, allowed + rounding);
    keeps = keeps && !slow;
    bool const fresh = slow || (iteration == 0 && served == 0);
    if (fresh || iteration == 0) {
      if (!factorise(s, m, wall, fresh ? &xf : nullptr, dt, w, loads)) return outcome;
      prepare(enclosed, *s.newton, m.fixed, dt);
    }
    previous = now;
    next.a += correction(enclosed, *s.newton, residual) / (w.beta * dt * dt);
    ++outcome.iterations;
  }
}

}  // namespace

template <class Body>
ImplicitStepper implicit_stepper(Body const& m, Rayleigh const& damping, double rho_inf)
{
  return implicit_stepper(m, damping, m.reference, {}, rho_inf);
}

template <class Body>
ImplicitStepper implicit_stepper(Body const& m, Rayleigh const& damping,
                                 Eigen::VectorXd const& state, std::span<Load const> elastic,
                                 double rho_inf)
{
  core::require(rho_inf >= 0 && rho_inf <= 1,
                "the spectral radius at infinite frequency must lie between 0 and 1");
  ImplicitStepper s;
  s.damping = damping;
  s.rho_inf = rho_inf;
  s.mass = per_component(lumped_mass(m), Body::dimension);
  s.K0 = damping_stiffness(m, state, elastic);
  s.newton = std::make_unique<NewtonMatrix>();
  return s;
}

template <class Body>
ImplicitReport advance(ImplicitStepper& s, Body& m, Eigen::VectorXd const& F0,
                       std::span<NodeBlock<Body> const> Z, double dt, std::span<Load const> loads,
                       Enclosures* volumes)
{
  WallForce<Body> const wall{F0, Z};
  EnclosedNewton enclosed;
  enclosed.volumes = volumes;
  if (volumes) volumes->mean = Eigen::VectorXd::Zero(volumes->pressure.size());
  if (s.acceleration.size() == 0) start(s, m, wall, enclosed, dt, loads);
  ImplicitReport report;
  double done = 0, part = 1;  // shares of dt
  State next;
  s.mean = Eigen::VectorXd::Zero(m.position.size());
  while (done < 1) {
    part = std::min(part, 1 - done);
    State const old{m.position, m.velocity, s.acceleration};
    auto const outcome = try_step(s, m, wall, enclosed, old, next, part * dt, loads);
    report.iterations += outcome.iterations;
    if (outcome.converged) {
      s.mean += part * mean_velocity(old, next, part * dt, weights(s.rho_inf));
      m.position = next.x, m.velocity = next.v, s.acceleration = next.a;
      if (volumes) {
        volumes->pressure = enclosed.pressure;
        volumes->mean += part * enclosed.pressure;
      }
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

template <class Body>
ImplicitReport advance(ImplicitStepper& s, Body& m, double dt, std::span<Load const> loads)
{
  return advance(s, m, {}, {}, dt, loads);
}

template ImplicitStepper implicit_stepper(Membrane const&, Rayleigh const&, double);
template ImplicitStepper implicit_stepper(Sheet const&, Rayleigh const&, double);
template ImplicitStepper implicit_stepper(Membrane const&, Rayleigh const&, Eigen::VectorXd const&,
                                          std::span<Load const>, double);
template ImplicitStepper implicit_stepper(Sheet const&, Rayleigh const&, Eigen::VectorXd const&,
                                          std::span<Load const>, double);
template ImplicitReport advance(ImplicitStepper&, Membrane&, double, std::span<Load const>);
template ImplicitReport advance(ImplicitStepper&, Sheet&, double, std::span<Load const>);
template ImplicitReport advance(ImplicitStepper&, Membrane&, Eigen::VectorXd const&,
                                std::span<Eigen::Matrix2d const>, double, std::span<Load const>,
                                Enclosures*);
template ImplicitReport advance(ImplicitStepper&, Sheet&, Eigen::VectorXd const&,
                                std::span<Eigen::Matrix3d const>, double, std::span<Load const>,
                                Enclosures*);

}  // namespace velum::structure
