#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <span>

namespace velum::structure {

struct StaticOptions {
  double tolerance = 1e-10;     ///< largest residual / largest nodal force
  int max_iterations = 150;     ///< per load step
  double min_load_step = 1e-3;  ///< smallest part of the load tried before giving up
  double largest_stretch = 6;   ///< beyond it the membrane counts as burst
};

struct StaticReport {
  int iterations = 0;   ///< linear solves, rejected and cut-back ones included
  int load_steps = 0;   ///< load steps that converged
  double residual = 0;  ///< largest nodal residual / largest nodal force
};

/// Moves the body (a Membrane or a Sheet) to static equilibrium, elastic force + sum of loads = 0,
/// and sets the velocity of its free components to zero.
///
/// Newton with the exact tangent K, damped as pseudo-transient continuation (Kelley and Keyes, SIAM
/// J. Numer. Anal. 35 (1998) 508, doi:10.1137/S0036142996304796): (K + s M) dx = residual, s from
/// how well the last step was predicted. The flat unloaded membrane, whose K is singular, is thus a
/// valid start. K + s M is kept positive definite, so only stable equilibria are reached. The full
/// load is tried first; where that fails, it is cut back and raised in steps.
///
/// Throws core::Divergence where no stable equilibrium is found: the sentence has the fraction of
/// the load that was carried, the node of the largest residual and the likely cause (such as the
/// inflation limit point, p a / (mu H) = 1.879 of a clamped disc).
template <class Body>
StaticReport static_solve(Body& m, std::span<Load const> loads, StaticOptions const& options = {});

}  // namespace velum::structure
