#pragma once
#include "structure/load.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

#include <functional>

namespace velum::structure {

/// What inflates a body by its volume: the volume at positions x, and the load of unit pressure,
/// which must be its gradient.
struct Inflation {
  std::function<double(Eigen::VectorXd const& x)> volume;
  Load unit_pressure;
};

/// Inflation of a sheet towards its plus sides, or of a membrane between its line and that of its
/// reference. Kept by reference: the body must outlive it.
Inflation inflation(Sheet const& s);
Inflation inflation(Membrane const& m);

struct VolumeOptions {
  double tolerance = 1e-10;  ///< largest residual / largest nodal force, and of the volume
  int max_iterations = 25;   ///< per step of the volume
  double min_step = 1e-3;    ///< smallest part of the way tried before giving up
};

struct VolumeReport {
  double pressure = 0;
  int iterations = 0;
  int steps = 0;
};

/// Moves the body to static equilibrium at a given volume; the pressure is found with it, so that
/// the path goes on past the limit point of inflation, where no larger pressure has a solution.
/// Newton on the bordered system
///   [K  -g] [dx]   [elastic force + p g]
///   [g^T 0] [dp] = [V* - V             ],   g = dV/dx, K = -d(elastic force + p g)/dx,
/// from the current state, whole or in steps of the volume.
/// @param pressure  of the current state; the start must be tense (not flat and unloaded)
/// Throws core::Divergence where no equilibrium is found: the part of the way, the residual.
template <class Body>
VolumeReport solve_at_volume(Body& body, Inflation const& by, double volume, double pressure,
                             VolumeOptions const& options = {});

}  // namespace velum::structure
