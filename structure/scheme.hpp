#pragma once
#include "structure/damping.hpp"
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <span>
#include <string>

namespace velum::structure {

enum class TimeScheme { explicit_substeps, implicit };

struct SchemeChoice {
  TimeScheme scheme;
  int substeps;          ///< of a step: explicit ones, or 1
  std::string sentence;  ///< what was chosen and why, to be printed
};

/// How a body is to take a step dt: by explicit sub-steps where they cost no more than one implicit
/// step, substeps_for(dt, stable) <= cost_ratio, implicitly else. Stability is all that this looks
/// at: either way dt has to resolve the motion that is wanted, some 20 steps to its period.
/// @param dt, stable  the step wanted and stable_step(), one unit of time; stable may be infinite
/// @param cost_ratio  of an implicit step to a sub-step: typical_cost_ratio() or one measured
/// @param unit        name of that unit, for the sentence
/// Throws InputError where a number is not positive.
SchemeChoice choose_scheme(double dt, double stable, double cost_ratio,
                           std::string const& unit = "s");

/// What an implicit step costs in explicit sub-steps of the same body, mostly good to a factor of
/// two (25 of 42 measurements; 6.7 off at worst, 1801 nodes in short steps): means of measurements
/// on inflated discs of 40 to 1320 elements and of 127 to 1801 nodes, steps 10 to 1000 times the
/// stable one; short ones share tangents and are the cheaper. It depends on the body alone, so that
/// a run chooses alike on every machine. With beta > 0 a sub-step solves a linear system too and is
/// the dearer.
double typical_cost_ratio(Membrane const& m, Rayleigh const& damping);
double typical_cost_ratio(Sheet const& s, Rayleigh const& damping);

/// The same in a coupled run, or one between lumped chambers, where the step is that of the fluid:
/// so short that one correction by the tangent of an earlier step does. Measured in the closed
/// valve on chains of 84 nodes, 3 with bending and 3.5 without; explicit sub-steps too factor the
/// wall blocks once.
double coupled_cost_ratio(Membrane const& m);

/// The same measured now, from the body's present state under the loads, on copies of it: wall
/// times of an implicit step of length dt and of sub-steps of 0.8 `stable`, the quickest of each.
/// Infinite where no implicit step is possible.
template <class Body>
double measured_cost_ratio(Body const& body, Rayleigh const& damping, double dt, double stable,
                           std::span<Load const> loads);

}  // namespace velum::structure
