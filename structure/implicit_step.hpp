#pragma once
#include "structure/damping.hpp"
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <Eigen/SparseCore>

#include <span>

namespace velum::structure {

/// What the implicit scheme keeps between calls.
struct ImplicitStepper {
  Rayleigh damping;
  double rho_inf;                  ///< spectral radius at infinite frequency, 0 to 1
  Eigen::VectorXd mass;            ///< lumped, per component     [2N or 3N]
  Eigen::SparseMatrix<double> K0;  ///< of the reference state
  Eigen::VectorXd acceleration;    ///< empty before the first step
};

struct ImplicitReport {
  int steps = 0;        ///< steps of the scheme that made up dt
  int cut_backs = 0;    ///< steps thrown away because Newton failed
  int iterations = 0;   ///< linear solves, failed steps included
  double residual = 0;  ///< largest of the accepted steps, relative to the nodal forces
};

/// Where in a step the scheme takes its forces, as a share of it: 1 - alpha_f = 1 / (1 + rho_inf).
/// A load that varies in time keeps second order when it is set to what it is there.
inline double time_of_loads(ImplicitStepper const& s) { return 1 / (1 + s.rho_inf); }

/// @param m  the body, a Membrane or a Sheet
template <class Body>
ImplicitStepper implicit_stepper(Body const& m, Rayleigh const& damping, double rho_inf = 0.5);

/// Advances position and velocity by dt with the generalised-alpha scheme (Chung and Hulbert, J.
/// Appl. Mech. 60 (1993) 371, doi:10.1115/1.2900803), forces taken at the intermediate position:
///   M a_m + (alpha M + beta K0) v_f = elastic force(x_f) + sum of loads(x_f),
/// by Newton with the exact tangent. Second order, unconditionally stable on linear problems. Where
/// Newton fails, the step is halved and sub-cycled until dt is reached. Stiff contact wants damping
/// of what the step does not resolve: rho_inf of 0.5 or less.
/// Throws core::Divergence where 2^-12 of dt still fails.
template <class Body>
ImplicitReport advance(ImplicitStepper& stepper, Body& m, double dt, std::span<Load const> loads);

}  // namespace velum::structure
