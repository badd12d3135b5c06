#pragma once
#include <vector>

#include "cases/app/coupled_scene.hpp"
#include "cases/app/sealing.hpp"
#include "lbm/observe.hpp"

namespace velum::cases {

/// State of a coupled scene at one instant; SI units.
struct Measurement {
  double time = 0;
  double pressure_above = 0, pressure_outside = 0, pressure_inside = 0;
  double volume_inside = 0;  // under the membrane within the seat
  double mass_inside = 0;    // of fluid there, density times volume
  double centre = 0;         // axial place of the membrane's middle
  double penetration = 0, seat_force = 0;
  double gap = 0;         // the narrowest between membrane and seat; below 0 where they touch
  double flow = 0;        // out of the outlet, with what orifices bring there, m3/s: mean since
                          // the last measurement
  double gap_by_law = 0;  // share of these steps in which the gap's flow came from its law
  std::vector<double> network;  // what valve_columns() names last
  double speed_max = 0;         // of the fluid
  double pressure_least = 0;    // in any of its cells
  double density_error = 0;     // largest |rho - rho0| / rho0
  // since the start of the run, volume at rest density
  double outflow = 0, inflow = 0;
  double through_seat = 0, through_membrane = 0;
  bool sealed = false;  // no path of populations from inlet to outlet
};

/// Sums that a run keeps from step to step, lattice units.
struct Flows {
  double out = 0, in = 0;        // through the lattice's own openings
  double recent = 0, steps = 0;  // out of the outlet since the last measurement
  double by_law = 0;             // of these steps
};
template <class Real, template <class> class Body>
void add_flows(Flows& flows, CoupledScene<Real, Body> const& s);

template <class Real, template <class> class Body>
Measurement measure(CoupledScene<Real, Body> const& s, Scene const& scene, Flows& flows,
                    double time);

/// What most often makes a scene with these settings diverge, and what to do.
template <class Real, template <class> class Body>
std::string likely_cause(CoupledScene<Real, Body> const& s);

/// Throws core::Divergence with step, cell, place and likely cause when the fluid has left the
/// range of the method: not finite, faster than its sound, or density off by half.
template <class Real, template <class> class Body>
void guard(CoupledScene<Real, Body> const& s, lbm::Observation const& seen, long step);

}  // namespace velum::cases
