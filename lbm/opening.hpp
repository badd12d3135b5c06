#pragma once
#include "lbm/link.hpp"

namespace velum::lbm {

/// Speed of sound of every lattice, cells per step.
inline constexpr double sound = 0.57735026918962576;  // 1/sqrt(3)

/// What an opening imposes.
///   velocity   normal velocity, times the profile
///   flow_rate  volume per step
///   traction   a velocity profile scaled so that the mean normal traction is the target
///   pressure   pressure, velocity free
///   outflow    pressure, velocity free, sound leaves, flow back in is tamed
enum class OpeningKind { velocity, flow_rate, traction, pressure, outflow };

/// An opening in the walls: its links and the state of its control. Lattice units.
struct Opening {
  OpeningKind kind = OpeningKind::velocity;
  LinkList links;
  core::Vec3 normal = {1, 0, 0};  // into the fluid
  double area = 0;                // sum of 6 w |c.n| ring: pressure times area is the force at rest

  double velocity = 0;       // of the inflow, as imposed in the last step
  double integral = 0;       // memory of the traction control
  double gain = 2e-4;        // of that, per step; stable below c_s / 4L in chambers L cells long
  double last_traction = 0;  // traction (of a gap's edge: `before`) one step ago, for its control
  double slow_velocity = 0;  // mean inflow that the outflow condition does not resist
  double memory = 5000;      // steps over which it is the mean
  double pressure = 0;       // imposed in the last step, less that of the rest state

  double mass_flow = 0;  // into the fluid in the last step, mass per step
  double traction = 0;   // mean normal traction over the opening in the last step
  double before = 0;     // pressure_before() the last step, of the edge of a gap
};

/// Finds the area of an opening whose links and normal are set.
template <class Real, class L, class Stored>
double opening_area(Fluid<Real, L, Stored> const& fluid, std::vector<Link> const& links,
                    core::Vec3 normal);

/// Mean pressure of the cells before an opening, less that of the rest state; weighed as its area
/// is. Before apply().
template <class Real, class L, class Stored>
double pressure_before(Fluid<Real, L, Stored> const& fluid, Opening const& opening);

/// Imposes the target (velocity, volume per step, traction or pressure less that of the rest state;
/// lattice units) and measures mass flow and traction. The traction is the momentum that crosses
/// the opening per area less what is convected (rho U^2; of pressure and outflow the mean of
/// rho u_n^2): p - n.tau.n.
///
/// velocity, flow_rate: where fluid comes in the half-way rule, f_o = f_i - 6 w c.n U; where it
/// leaves, which the full population and a velocity along the opening held at zero make unstable
/// below a nu of some 0.01, the same rule for the cell's equilibrium and its own velocity along the
/// opening, f_o = feq_i - 6 w c.(U n + u_t), and U in this raised a little so that the mass is
/// exact.
/// traction: U relaxes to  I + (p_target - p)/(rho c_s),  dI = k (p_target - p)/(rho c_s): along
/// the outgoing characteristic dp = rho c_s dU, so sound is absorbed, and the integral brings the
/// mean traction to the target whatever flows; while the flow grows it stays behind by rho c_s / k
/// dU/dt, so that k = `gain` is to be as large as the chamber allows.
/// pressure, outflow: where fluid leaves anti-bounce-back of the cell's equilibrium, f_o =
/// feq_o(2 rho_b - rho, u), which lets vortices and jets pass at low viscosity. pressure: where it
/// comes in the full anti-bounce-back, f_o = -f_i + 2 w rho_b (1 + 9/2 (c.u)^2 - 3/2 u^2), Ginzburg
/// et al. 2008, with the cell's own velocity. outflow: adds rho c_s (U - slow U) to the pressure,
/// so that a plane wave leaves, and where fluid comes back sends feq_o(rho_b, 0): what enters
/// brings no momentum, or eddies would draw on the reservoir outside without end (the energy
/// condition u.n >= 0 of a traction-free boundary). pressure: rho_b is 3 p and what brings the
/// traction, the mean normal momentum that crosses the opening less what the velocity of the cells
/// convects, to p: an equilibrium lacks the odd moments of a stream beside a wall, whose pressure
/// is some hundredths of rho c_s u and at low Mach number not small against that of the flow.
/// outflow is off by that much.
///
/// Of a plane pulse, Gaussian of standard deviation 5, 10, 20 and 40 cells, outflow sends back at
/// most 10, 8, 5 and 3 %, traction 10, 8, 6 and 4 % (nu = 0.001; less at 0.1), pressure all of it
/// with its sign reversed (tests/lbm/openings_let_sound_out.cpp).
///
/// Limits: a pressure opening feeds what comes in through it. Against a held rate it amplifies
/// sound below a nu of some 0.01; eddies that blow in through it grow, in space below the same, in
/// the plane below some 1e-3. Let traction or outflow drive such a flow, and outflow end it.
template <class Real, class L, class Stored>
void apply(Fluid<Real, L, Stored>& fluid, Opening& opening, double target);

}  // namespace velum::lbm
