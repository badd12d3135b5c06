#pragma once
#include "lbm/fluid.hpp"

namespace velum::lbm {

/// Adds to the equilibria of set_equilibrium() the viscous stress of the same velocities, so that
/// it acts from the first step: after collision, in the order of Chapman and Enskog,
///   f_i - feq_i = 9/2 w_i (c_ia c_ib - delta_ab/3) P_ab,  P = -(1/omega - 1) 2/3 S,
/// S the deviator of the strain rate by central differences, one-sided where the box ends. Without
/// it the first step diffuses as if the viscosity were 1/6, and a wave of wave number k loses
/// k^2/6 of its amplitude at once (Mei, Luo, Lallemand & d'Humieres, Comput. Fluids 35 (2006) 855,
/// doi:10.1016/j.compfluid.2005.08.008, on initial conditions).
template <class Real, class L, class Stored>
void add_viscous_stress(Fluid<Real, L, Stored>& fluid, CellStates const& state);

}  // namespace velum::lbm
