#pragma once
#include "cases/app/certificate.hpp"
#include "cases/app/coupled_output.hpp"
#include "cases/app/material_range.hpp"

namespace velum::cases {

/// Steps at which a march does something, counted from 1.
struct Calendar {
  double dt;            // s
  long settle, total;   // last step of the first stage, and of all
  long window, sample;  // leaks are averaged from this step on; every so many steps a row
};
Calendar calendar(Schedule const& run, double dt);

/// What a march keeps beside the state of its scene.
struct March {
  long step = 0;      // steps taken
  Measurement now;    // the last one,
  long measured = 0;  // after this step
  Flows flows;
  Certificate certificate;
  StretchRecord stretch;
  CoupledOutput out;
  double next_checkpoint = 0;  // s
  long checkpoints = 0;        // written so far
  long fallen = 0;             // times that it fell back to a shorter step
  double seconds = 0;          // wall time of the runs that this one goes on from
};

/// Stretch of the membrane now, records and certificate from the measurement.
template <class Real, template <class> class Body>
void take_stock(March& march, CoupledScene<Real, Body> const& s, Scene const& scene,
                Calendar const& when);

/// One step of everything, to the time n dt; or, with the drivers held as they are at t = 0, of
/// what comes before that. Where the membrane fails, the sentence gets step, time and likely cause.
template <class Real, template <class> class Body>
void take_step(CoupledScene<Real, Body>& s, Scene const& scene, long n, bool shut,
               bool held = false);

}  // namespace velum::cases
