// problem:   clamped circular plate under uniform pressure, small deflections; a flat disc that is
//            stretched evenly
// reference: w = p (a^2 - r^2)^2 / (64 D): the strain of the faces is H/2 w'' = p a^2 H / (16 D) at
//            the rim and half of that, of the other sign, on the axis (Timoshenko &
//            Woinowsky-Krieger 1959, section 16); evenly: the stretch itself
// measure:   largest stretch of the faces less one, over the reference; its error over three grids
// tolerance: 4 % with 80 elements, order 1 +- 0.2; 1 % on the axis where the rim turns freely,
// whose
//            moment is (3 + nu) p a^2 / 16; 1e-12
// why:       first order at the clamped rim, where the slope of half an element stands for the
//            curvature, as the docstring says: 2.5 % seen with 80 elements
#include "structure/face_stretch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "structure/line_bending.hpp"
#include "structure/pressure_load.hpp"
#include "structure/static_solve.hpp"
#include "tests/support/order.hpp"

namespace velum::structure {
namespace {

constexpr double mu = 1e6, H = 1e-3, a = 0.02, D = mu * H * H * H / 3;

Membrane disc(int elements)
{
  return flat_membrane({core::Symmetry::axisymmetric, 0, a, a / elements, [](double) { return H; },
                        neo_hookean_rubber(mu), 1100});
}

/// Error of the strain at the clamped rim.
double error(int elements)
{
  auto m = disc(elements);
  auto const bending = line_bending(m, Rim::clamped);
  double const p = 1e-3 * H * 64 * D / std::pow(a, 4);
  auto const pressure = uniform_pressure(m, Side::minus, p);
  std::array const loads{pressure_load(m, pressure), bending_load(bending)};
  static_solve(m, loads);
  return (largest_face_stretch(m, Rim::clamped) - 1) / (p * a * a * H / (16 * D)) - 1;
}

TEST(FaceStretch, is_that_of_a_clamped_plate)
{
  std::vector<double> const errors = {std::abs(error(20)), std::abs(error(40)),
                                      std::abs(error(80))};
  EXPECT_LT(errors.back(), 0.04);
  EXPECT_NEAR(tests::order({4, 2, 1}, errors), 1, 0.2);
}

TEST(FaceStretch, is_that_of_the_axis_where_the_rim_turns)
{
  auto m = disc(80);
  auto const bending = line_bending(m, Rim::hinged);
  double const p = 1e-3 * H * 64 * D / std::pow(a, 4);
  auto const pressure = uniform_pressure(m, Side::minus, p);
  std::array const loads{pressure_load(m, pressure), bending_load(bending)};
  static_solve(m, loads);
  // (3 + nu) p a^2 / 16 is the moment on the axis, over D (1 + nu) its curvature
  double const strain = H / 2 * 3.5 * p * a * a / (16 * D * 1.5);
  EXPECT_NEAR((largest_face_stretch(m, Rim::hinged) - 1) / strain, 1, 0.01);
}

TEST(FaceStretch, of_an_even_stretch_is_that_stretch)
{
  auto m = disc(20);
  m.position *= 1.3;
  EXPECT_NEAR(largest_face_stretch(m, Rim::clamped), 1.3, 1e-12);
}

}  // namespace
}  // namespace velum::structure
