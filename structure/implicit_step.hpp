#pragma once
#include "structure/damping.hpp"
#include "structure/enclosure.hpp"
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/newton_matrix.hpp"
#include "structure/sheet.hpp"

#include <Eigen/SparseCore>

#include <memory>
#include <span>

namespace velum::structure {

/// What the implicit scheme keeps between calls.
struct ImplicitStepper {
  Rayleigh damping;
  double rho_inf;                  ///< spectral radius at infinite frequency, 0 to 1
  Eigen::VectorXd mass;            ///< lumped, per component     [2N or 3N]
  Eigen::SparseMatrix<double> K0;  ///< of the state whose stiffness is damped
  Eigen::VectorXd acceleration;    ///< empty before the first step
  Eigen::VectorXd mean;            ///< velocity, over the last call's dt
  std::unique_ptr<NewtonMatrix> newton;
  double tangent_step = 0;  ///< longest step that the tangent in it may serve; 0: none
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

/// Stepper of a body (a Membrane or a Sheet) with the stiffness of its reference state in the
/// damping.
template <class Body>
ImplicitStepper implicit_stepper(Body const& m, Rayleigh const& damping, double rho_inf = 0.5);

/// The same with the stiffness of a given state and of the body's own loads, as in
/// explicit_step.hpp.
template <class Body>
ImplicitStepper implicit_stepper(Body const& m, Rayleigh const& damping,
                                 Eigen::VectorXd const& state, std::span<Load const> elastic,
                                 double rho_inf = 0.5);

/// Advances position and velocity by dt with the generalised-alpha scheme (Chung and Hulbert, J.
/// Appl. Mech. 60 (1993) 371, doi:10.1115/1.2900803), forces taken at the intermediate position:
///   M a_m + (alpha M + beta K0) v_f = elastic force(x_f) + sum of loads(x_f),
/// by Newton; a tangent, exact where it was found, serves for as long as its corrections converge
/// well, from step to step. Second order, unconditionally stable on linear problems. Where
/// Newton fails, the step is halved and sub-cycled until dt is reached. Stiff contact wants damping
/// of what the step does not resolve: rho_inf of 0.5 or less. Prescribed components keep their
/// velocity.
/// Throws core::Divergence where 2^-12 of dt still fails.
template <class Body>
ImplicitReport advance(ImplicitStepper& stepper, Body& m, double dt, std::span<Load const> loads);

/// The same with the force of a fluid beside the loads, F0 - Z (x' - x)/h over each step h that dt
/// is made of. With vbar = (x(t + dt) - x(t))/dt, left in stepper.mean, its impulse on a free node
/// is dt (F0 - Z vbar) exactly, and by it the momentum at the time that the scheme's acceleration
/// is ahead of,
///   M (v + (1/2 - alpha_f) h a),   alpha_f = rho_inf/(1 + rho_inf),
/// changes in a step: for rho_inf = 1 that is M v. First order where the force changes from call to
/// call or Z is felt, since it is that of the middle of the step while the scheme balances at
/// 1 - alpha_f of it; second for rho_inf = 1. Stable for Z of any size, which rho_inf < 1 damps
/// within a few steps.
/// @param F0  force at zero wall velocity                                   [2N or 3N]
/// @param Z         symmetric positive semi-definite block per node, or empty     [N]
/// @param enclosed  volumes whose pressures push the body, found with its motion (enclosure.hpp; p'
///                  of each sub-cycled step by the mean velocity over it), or null
template <class Body>
ImplicitReport advance(ImplicitStepper& stepper, Body& m, Eigen::VectorXd const& F0,
                       std::span<NodeBlock<Body> const> Z, double dt, std::span<Load const> loads,
                       Enclosures* enclosed = nullptr);

}  // namespace velum::structure
