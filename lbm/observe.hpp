#pragma once
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// What the guard and the result need to know of the whole fluid.
struct Observation {
  double speed_max = 0;             // largest |u|, lattice units
  double speed_squared_mean = 0;    // over the cells with fluid
  double rho_min = 0, rho_max = 0;  // of the density less 1
  double mass = 0;                  // sum of ring * (density less 1)
  long cells = 0;                   // with fluid
  long not_finite = 0;              // cells whose density or velocity is not a number
  bool clipped = false;             // 16-bit storage: a population has reached the end of its range
};

/// Sweeps all cells with fluid once.
template <class Real, class L, class Stored>
Observation observe(Fluid<Real, L, Stored> const& fluid);

struct CellPlace {
  int i, j, k;
};
/// The cell of the largest speed, or one that is not finite.
/// @pre the fluid has a cell
template <class Real, class L, class Stored>
CellPlace worst_cell(Fluid<Real, L, Stored> const& fluid);

/// Mean and largest eddy viscosity over the cells with fluid, from the populations after collision.
struct EddyViscosity {
  double mean = 0, max = 0;
};
template <class Real, class L, class Stored>
EddyViscosity eddy_viscosity(Fluid<Real, L, Stored> const& fluid);

}  // namespace velum::lbm
