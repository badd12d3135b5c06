#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "ibm/chambers.hpp"
#include "ibm/contact_load.hpp"
#include "ibm/face_pressure.hpp"
#include "lbm/opening.hpp"
#include "structure/stepper.hpp"

namespace velum::ibm {

/// How fluid and structure find the velocity of the faces within a step.
///   implicit  the structure carries the fluid's block Z; stable at every mass ratio
///   explicit_ the old velocity bounces the fluid back, its force moves the structure afterwards:
///             unstable below a mass ratio of some tens; kept to be measured
enum class Scheme { implicit, explicit_ };

/// Fluid, membrane and seat of one scene, in lattice units. Body is Sharp or Diffuse.
template <class Real, template <class> class Body>
struct Coupled {
  lbm::Fluid<Real> fluid;
  std::vector<lbm::Opening> openings;
  std::vector<double> targets;  // of the openings, as opening.hpp says
  Body<Real> body;
  structure::Membrane membrane;
  structure::Stepper stepper;
  std::vector<structure::Load> loads;  // spring and contact
  std::shared_ptr<SeatContact> seat;   // empty without contact
  std::optional<Chambers> chambers;    // lumped, where the scene has any
  core::Obstacle walls;                // all rigid solids
  FacePressure pressure;
  Scheme scheme = Scheme::implicit;
  bool one_way = false;         // the membrane drives the fluid and does not feel it
  int substeps = 1;             // of the explicit stepper
  double membrane_seconds = 0;  // wall time that the membrane's own steps took so far
  Ledger ledger;
};

}  // namespace velum::ibm
