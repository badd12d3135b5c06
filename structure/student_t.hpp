#pragma once

namespace velum::structure {

/// Half width, in standard errors, of the interval that holds a share of Student's distribution:
/// 12.7 for 95 % with one degree of freedom, 1.96 with many.
/// Abramowitz and Stegun, Handbook of Mathematical Functions (1972), 26.7.3 and 26.7.4, inverted by
/// bisection.
/// @param degrees  of freedom, >= 1;  @param share  in (0, 1)
double student_quantile(int degrees, double share);

}  // namespace velum::structure
