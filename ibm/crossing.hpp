#pragma once
#include "ibm/ledger.hpp"
#include "lbm/fluid.hpp"

namespace velum::ibm {

/// Mass that streamed in this step from one part of the fluid into another where a membrane lets
/// fluid through. The parts are those of fluid.active (1 plus, 2 minus, 3 between the faces) and,
/// under the minus face, what lies within the dividing radius: downstream.
struct Crossing {
  double up = 0;    // into the fluid upstream, through the faces
  double down = 0;  // into the fluid downstream, through the minus face
  double seat = 0;  // from the minus side upstream to downstream
};

/// Adds up the links between the parts; the populations have arrived and not yet collided.
template <class Real>
Crossing crossing(lbm::Fluid<Real> const& fluid, double divide);

}  // namespace velum::ibm
