#pragma once
#include <functional>
#include <string>
#include <vector>

/// What the stiffness of a contact costs and what it is worth, for both methods.
namespace velum::cases {

/// A clamped rubber disc pressed on a round ring seat, solved with one stiffness by one method.
struct PenaltyRow {
  std::string method;    // "penalty" or "augmented_lagrangian"
  double stiffness;      // Pa/m
  double penetration;    // the largest, m
  double seat_force;     // N
  double force_error;    // of the reference's
  double largest;        // contact pressure, Pa
  double largest_error;  // of the reference's
  int solves;            // nonlinear ones
  int iterations;        // linear solves in all
};

/// Rows over the stiffness, 1e9 to 1e12 Pa/m, each handed over when it is found. Errors are against
/// the augmented Lagrangian with 2e11 Pa/m, whose penetration is round-off. The disc is that of the
/// valve: radius 8.25 mm, 1 mm thick, shear modulus 0.946 MPa, under 50 kPa; the ring's radius is
/// 5.25 mm, its section 0.5 mm, 0.05 mm from the flat disc.
/// @param rings       of triangles
/// @param per_decade  stiffnesses
void contact_penalty(int rings, int per_decade,
                     std::function<void(PenaltyRow const&)> const& found);

/// All rows as a CSV file.
std::string csv(std::vector<PenaltyRow> const& rows);

}  // namespace velum::cases
