#pragma once
#include "structure/mooney_rivlin.hpp"

namespace velum::structure {

/// Energy per reference area of a membrane, its nominal tensions and their derivatives.
struct MembraneEnergy {
  double W;              ///< energy / reference area
  double T1, T2;         ///< dW/dl1, dW/dl2: force / reference width
  double K11, K12, K22;  ///< second derivatives
};

/// Incompressible membrane in plane stress, the thickness stretch being 1/(l1 l2), so that
///   I1 = l1^2 + l2^2 + (l1 l2)^-2,  I2 = l1^-2 + l2^-2 + (l1 l2)^2.
/// Holzapfel, Nonlinear Solid Mechanics (2000), sections 6.5 and 6.2. Neo-Hookean with l2 = 1 it is
/// plane strain: T = mu H (l - l^-3); small strains see the modulus 4 mu H, with mu = 2 (c10 +
/// c01).
/// @param H   undeformed thickness
/// @param l1  stretch along the meridian;  @param l2  hoop stretch (1 in the plane)
inline MembraneEnergy membrane_energy(MooneyRivlin const& m, double H, double l1, double l2)
{
  double const a = 1 / (l1 * l1), b = 1 / (l2 * l2), ab = a * b, l12 = l1 * l2;
  auto const w = invariant_energy(m, 1 / a + 1 / b + ab - 3, a + b + 1 / ab - 3);
  // halves of the derivatives of the invariants
  double const p1 = l1 - ab / l1, p2 = l2 - ab / l2;        // I1 by l1, l2
  double const q1 = l1 / b - a / l1, q2 = l2 / a - b / l2;  // I2
  double const p11 = 1 + 3 * ab * a, p22 = 1 + 3 * ab * b;  // I1, twice
  double const q11 = 1 / b + 3 * a * a, q22 = 1 / a + 3 * b * b;
  double const p12 = 2 * ab / l12, q12 = 2 * l12;
  double const one = 2 * H * w.W1, two = 2 * H * w.W2;
  double const h11 = 4 * H * w.W11, h12 = 4 * H * w.W12, h22 = 4 * H * w.W22;
  return {.W = H * w.W,
          .T1 = one * p1 + two * q1,
          .T2 = one * p2 + two * q2,
          .K11 = one * p11 + two * q11 + h11 * p1 * p1 + 2 * h12 * p1 * q1 + h22 * q1 * q1,
          .K12 = one * p12 + two * q12 + h11 * p1 * p2 + h12 * (p1 * q2 + p2 * q1) + h22 * q1 * q2,
          .K22 = one * p22 + two * q22 + h11 * p2 * p2 + 2 * h12 * p2 * q2 + h22 * q2 * q2};
}

}  // namespace velum::structure
