#pragma once

namespace velum::structure {

/// Energy per reference area of a membrane, its nominal tensions and their derivatives.
struct MembraneEnergy {
  double W;              ///< energy / reference area
  double T1, T2;         ///< dW/dl1, dW/dl2: force / reference width
  double K11, K12, K22;  ///< second derivatives
};

/// Incompressible neo-Hookean membrane in plane stress, the thickness stretch being 1/(l1 l2):
///   W = mu H / 2 (l1^2 + l2^2 + (l1 l2)^-2 - 3).
/// Holzapfel, Nonlinear Solid Mechanics (2000), sections 6.5 and 6.2. With l2 = 1 it is plane
/// strain: T = mu H (l - l^-3); small strains see the modulus 4 mu H.
/// @param mu_H  shear modulus times undeformed thickness
/// @param l1    stretch along the meridian;  @param l2  hoop stretch (1 in the plane)
inline MembraneEnergy neo_hookean(double mu_H, double l1, double l2)
{
  double const a = 1 / (l1 * l1), b = 1 / (l2 * l2), ab = a * b;
  return {.W = 0.5 * mu_H * (l1 * l1 + l2 * l2 + ab - 3),
          .T1 = mu_H * (l1 - ab / l1),
          .T2 = mu_H * (l2 - ab / l2),
          .K11 = mu_H * (1 + 3 * ab * a),
          .K12 = mu_H * 2 * ab / (l1 * l2),
          .K22 = mu_H * (1 + 3 * ab * b)};
}

}  // namespace velum::structure
