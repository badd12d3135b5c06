#pragma once

namespace velum::ibm {

/// Pressure that a passage takes from the flow Q through it,
///   dp = viscous Q + inertial |Q| Q,
/// any consistent set of units. Losses one after the other add.
struct Loss {
  double viscous = 0, inertial = 0;

  Loss& operator+=(Loss const& o)
  {
    viscous += o.viscous;
    inertial += o.inertial;
    return *this;
  }
};

struct Liquid {
  double density, viscosity;  ///< kinematic
};

/// Sharp-edged orifice or short passage: Q = Cd A sqrt(2 dp / rho) with a coefficient that falls at
/// low Reynolds number,
///   1/Cd^2 = 1/discharge^2 (1 + transition / Re),   Re = Q d / (A nu),
/// the interpolation between Stokes flow and a constant Cd that Merritt (Hydraulic Control Systems,
/// 1967, section 3.4) describes; transition is the Reynolds number at which friction and inertia
/// take the same share, some tens for a sharp edge, 64 l/d discharge^2 for a bore of length l.
/// @param diameter  hydraulic
Loss orifice_loss(Liquid const& liquid, double area, double diameter, double discharge,
                  double transition);

/// Gap between parallel faces, `width` across and `length` along the flow: plane Poiseuille flow
/// and the velocity head that is lost at entry and exit,
///   dp = 12 rho nu length / (width h^3) Q + rho / (2 discharge^2 (width h)^2) Q^2.
Loss slit_loss(Liquid const& liquid, double width, double height, double length, double discharge);

/// The flow that a pressure difference drives, of its sign.
double flow(Loss const& loss, double dp);
/// Its derivative by the pressure difference at that flow.
inline double slope(Loss const& loss, double q)
{
  return 1 / (loss.viscous + 2 * loss.inertial * (q < 0 ? -q : q));
}

}  // namespace velum::ibm
