#pragma once

namespace velum::structure {

/// Incompressible isotropic rubber, a polynomial in the invariants of C = F^T F (Mooney, J. Appl.
/// Phys. 11 (1940) 582; Rivlin, Phil. Trans. A 241 (1948) 379), energy per reference volume
///   W = c10 (I1-3) + c01 (I2-3) + c20 (I1-3)^2 + c11 (I1-3)(I2-3) + c02 (I2-3)^2.
/// c10 alone is neo-Hookean with mu = 2 c10; c10 and c01 are Mooney-Rivlin of two parameters, all
/// of five. The shear modulus at rest is mu = 2 (c10 + c01), Young's 3 mu.
struct MooneyRivlin {
  double c10 = 0, c01 = 0, c20 = 0, c11 = 0, c02 = 0;  ///< pressure

  bool operator==(MooneyRivlin const&) const = default;
};

constexpr MooneyRivlin neo_hookean_rubber(double shear_modulus)
{
  return {.c10 = shear_modulus / 2};
}

constexpr double shear_modulus(MooneyRivlin const& m) { return 2 * (m.c10 + m.c01); }

/// The same rubber in another unit of pressure.
constexpr MooneyRivlin scaled(MooneyRivlin const& m, double factor)
{
  return {.c10 = factor * m.c10,
          .c01 = factor * m.c01,
          .c20 = factor * m.c20,
          .c11 = factor * m.c11,
          .c02 = factor * m.c02};
}

/// The energy and its derivatives by the two invariants.
struct InvariantEnergy {
  double W, W1, W2, W11, W12, W22;
};

/// @param i1, i2  I1 - 3 and I2 - 3
constexpr InvariantEnergy invariant_energy(MooneyRivlin const& m, double i1, double i2)
{
  return {.W = m.c10 * i1 + m.c01 * i2 + m.c20 * i1 * i1 + m.c11 * i1 * i2 + m.c02 * i2 * i2,
          .W1 = m.c10 + 2 * m.c20 * i1 + m.c11 * i2,
          .W2 = m.c01 + m.c11 * i1 + 2 * m.c02 * i2,
          .W11 = 2 * m.c20,
          .W12 = m.c11,
          .W22 = 2 * m.c02};
}

}  // namespace velum::structure
