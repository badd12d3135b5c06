#pragma once
#include <Eigen/Core>

namespace velum::structure {

/// The scheme of implicit_step.hpp: Chung and Hulbert (1993), Eqs. 17, 20 and 25.
struct Weights {
  double alpha_m, alpha_f, gamma, beta;
};

inline Weights weights(double rho_inf)
{
  double const am = (2 * rho_inf - 1) / (rho_inf + 1), af = rho_inf / (rho_inf + 1);
  return {am, af, 0.5 - am + af, 0.25 * (1 - am + af) * (1 - am + af)};
}

/// Position, velocity, acceleration.   [2N or 3N]
struct State {
  Eigen::VectorXd x, v, a;
};

/// Mean velocity of a step.
inline Eigen::VectorXd mean_velocity(State const& old, State const& next, double dt,
                                     Weights const& w)
{
  return old.v + dt * ((0.5 - w.beta) * old.a + w.beta * next.a);
}

/// Sets place and velocity from the acceleration; returns the mean velocity.
inline Eigen::VectorXd follow(State const& old, State& next, double dt, Weights const& w)
{
  Eigen::VectorXd mean = mean_velocity(old, next, dt, w);
  next.x = old.x + dt * mean;
  next.v = old.v + dt * ((1 - w.gamma) * old.a + w.gamma * next.a);
  return mean;
}

}  // namespace velum::structure
