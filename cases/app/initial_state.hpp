#pragma once
#include "cases/app/lattice_scene.hpp"

namespace velum::cases {

/// A flow at a place.
struct FlowState {
  Vec3 velocity;              // m/s
  double kinematic_pressure;  // p / rho, m2/s2
};

/// The initial flow of a scene at p, and of taylor_green also its exact state at later times.
///
/// uniform: the velocity along x, everywhere at once.
/// taylor_green: Taylor & Green, Proc. R. Soc. A 158 (1937) 499, in a box of any sides,
///   u = -U sqrt(b/a) cos ax sin by e,  v = U sqrt(a/b) sin ax cos by e,
///   p = -rho U^2/4 (b/a cos 2ax + a/b cos 2by) e^2,  e = exp(-nu (a^2 + b^2) t),
///   a = 2 pi/L_x, b = 2 pi/L_y;
/// in space, in a cube, without a known solution at later times,
///   u = U sin ax cos ay cos az,  v = -U cos ax sin ay cos az,  w = 0,
///   p = rho U^2/16 (cos 2ax + cos 2ay) (cos 2az + 2).
/// shear_layer: Minion & Brown, J. Comput. Phys. 138 (1997) 734, doi:10.1006/jcph.1997.5843,
///   u = U tanh(k (y - 1/4)) below the middle, U tanh(k (3/4 - y)) above,  v = d U sin(2 pi (x +
///   1/4)), x and y over the sides of the box, in space the same for every z; the pressure is that
///   of rest, so a wave goes out.
FlowState initial_flow(Scene const& scene, Vec3 const& p, double time = 0);

/// Sets every cell to the initial flow: equilibrium, with the viscous stress of its velocity.
template <class Real, class L, class Stored>
void set_initial_state(Scene const& scene, LatticeScene<Real, L, Stored>& lattice);

}  // namespace velum::cases
