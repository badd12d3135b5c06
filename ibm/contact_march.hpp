#pragma once
#include <memory>

#include "ibm/contact_load.hpp"
#include "ibm/sheet_contact.hpp"
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"

namespace velum::ibm {

/// What a step in contact took and met: explicit at every sub-step, implicit at the end of each
/// part.
struct ContactSteps {
  int substeps = 0;
  int iterations = 0;       ///< linear solves, implicit alone
  double penetration = 0;   ///< the largest
  double force = 0;         ///< largest size of what the seat carries along the first axis
  Eigen::VectorXd impulse;  ///< of the seat on each node, sum of h times its force; explicit alone,
                            ///< where it is exact   [2N or 3N]
};

/// Advances a body that may touch a rigid seat by dt, in explicit sub-steps (explicit_step.hpp) as
/// long as contact_step() says, which is asked anew every few of them: from rest a pressure p takes
/// a node no farther in n sub-steps of omega h = 1/2 than n p / (4 k) each, a few static
/// penetrations. With M v' - M v on a free body whose other forces have no sum goes the sum of the
/// impulses, to rounding.
/// @param seat   a SeatContact of a Membrane, a contact::PointContact of a Sheet; plain penalty
/// @param loads  all others
/// Throws core::Divergence where the motion is no longer finite, or so fast that it would take more
/// than ten million sub-steps.
template <class Body, class Seat>
ContactSteps advance_in_contact(structure::ExplicitStepper& stepper, Body& m,
                                std::shared_ptr<Seat> const& seat, double dt,
                                std::span<structure::Load const> loads);

/// The same in implicit steps (implicit_step.hpp) with the contact's exact tangent, cut such that
/// no node moves by more than what lies between it and the seat, its half thickness at least: none
/// is then past the seat before the seat has pushed it.
/// Throws core::Divergence as structure::advance() does.
template <class Body, class Seat>
ContactSteps advance_in_contact(structure::ImplicitStepper& stepper, Body& m,
                                std::shared_ptr<Seat> const& seat, double dt,
                                std::span<structure::Load const> loads);

}  // namespace velum::ibm
