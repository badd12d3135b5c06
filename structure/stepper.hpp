#pragma once
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"

#include <span>
#include <variant>

namespace velum::structure {

/// Either scheme of a membrane's own steps.
using Stepper = std::variant<ExplicitStepper, ImplicitStepper>;

/// Takes the membrane through dt under F0 - Z v by the scheme that it has (explicit_step.hpp,
/// implicit_step.hpp) and returns its mean velocity, valid until the next call.   [2N]
/// @param substeps  of the explicit scheme
inline Eigen::VectorXd const& advance(Stepper& stepper, Membrane& m, Eigen::VectorXd const& F0,
                                      std::span<NodeBlock<Membrane> const> Z, double dt,
                                      int substeps, std::span<Load const> loads,
                                      Enclosures* enclosed)
{
  if (auto* const implicit = std::get_if<ImplicitStepper>(&stepper)) {
    advance(*implicit, m, F0, Z, dt, loads, enclosed);
    return implicit->mean;
  }
  return advance(std::get<ExplicitStepper>(stepper), m, F0, Z, dt, substeps, loads, enclosed);
}

}  // namespace velum::structure
