#pragma once

namespace velum::ibm {

/// Sums since the start of the run, in lattice mass: what entered the fluid and how.
/// Downstream is the minus side within the dividing radius, the rest is upstream.
struct Ledger {
  double swept_up = 0, swept_down = 0;  // pushed in by the moving faces
  double membrane_up = 0,
         membrane_down = 0;  // came out of a diffuse membrane by no motion: numerical leak
  double seat = 0;           // crossed the dividing radius under the membrane, inwards
};

}  // namespace velum::ibm
