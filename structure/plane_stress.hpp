#pragma once
#include "structure/mooney_rivlin.hpp"

#include <Eigen/Core>

namespace velum::structure {

/// Energy per reference volume of an incompressible material in plane stress, with its gradient and
/// Hessian by (C11, C22, C12) of the in-plane C = F^T F; the thickness stretch follows from
/// incompressibility, C33 = 1 / det C.
struct PlaneStress {
  double W;
  Eigen::Vector3d gradient;
  Eigen::Matrix3d hessian;
};

/// With a = tr C and d = det C the invariants are I1 = a + 1/d and I2 = d + a/d. Holzapfel,
/// Nonlinear Solid Mechanics (2000), section 6.2; the second Piola-Kirchhoff stress is twice the
/// gradient (C12 counted once).
inline PlaneStress plane_stress(MooneyRivlin const& m, double c11, double c22, double c12)
{
  double const a = c11 + c22, d = c11 * c22 - c12 * c12, v = 1 / d;
  auto const w = invariant_energy(m, a + v - 3, d + a * v - 3);
  double const I1d = -v * v, I2a = v, I2d = 1 - a * v * v;
  double const Wa = w.W1 + w.W2 * I2a, Wd = w.W1 * I1d + w.W2 * I2d;
  double const Waa = w.W11 + 2 * w.W12 * I2a + w.W22 * I2a * I2a;
  double const Wad = (w.W11 + w.W12 * I2a) * I1d + (w.W12 + w.W22 * I2a) * I2d - w.W2 * v * v;
  double const Wdd = w.W11 * I1d * I1d + 2 * w.W12 * I1d * I2d + w.W22 * I2d * I2d +
                     2 * v * v * v * (w.W1 + w.W2 * a);
  Eigen::Vector3d const da(1, 1, 0), dd(c22, c11, -2 * c12);
  Eigen::Matrix3d curvature;  // of d
  curvature << 0, 1, 0, 1, 0, 0, 0, 0, -2;
  return {w.W, Wa * da + Wd * dd,
          Waa * da * da.transpose() + Wad * (da * dd.transpose() + dd * da.transpose()) +
              Wdd * dd * dd.transpose() + Wd * curvature};
}

}  // namespace velum::structure
