// problem:   slowest mode of a clamped, stretched disc of triangles, small amplitude, Rayleigh
//            damping with the stiffness of the stretched state, explicit scheme
// reference: the mode's energy falls by exp(-2 d T) in a period T = 2 pi/(w0^2 - d^2)^(1/2), with
//            d = (alpha + beta w0^2)/2, w0 of the matrices' eigenvalue
// measure:   d from the energy after five periods
// tolerance: 1 %
// why:       first order in the step, w0 h = 0.01; the matrices are those of the scheme
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "structure/explicit_step.hpp"
#include "tests/structure/vibrating_disc.hpp"

namespace velum::tests {
namespace {

class SheetDecay : public testing::TestWithParam<structure::Rayleigh> {};

TEST_P(SheetDecay, is_that_of_the_mode)
{
  constexpr int periods = 5, steps = 600;
  auto d = vibrating_disc(DiscKind::membrane, 3, 1e-3);
  double const omega0 = d.mode.omega;
  // numbers without dimension, of the mode's own frequency
  structure::Rayleigh const damping{GetParam().alpha * omega0, GetParam().beta / omega0};
  double const decay = (damping.alpha + damping.beta * omega0 * omega0) / 2;
  double const period = 2 * std::numbers::pi / std::sqrt(omega0 * omega0 - decay * decay);

  Eigen::VectorXd const rest = d.sheet.position - 1e-3 * d.mode.shape;
  auto stepper = structure::explicit_stepper(d.sheet, damping, rest);
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(rest.size());
  double const before = energy(d, stepper.mass);
  structure::advance(stepper, d.sheet, none, {}, periods * period, periods * steps, {});
  double const after = energy(d, stepper.mass);
  double const measured = std::log(before / after) / (2 * periods * period);
  EXPECT_NEAR(measured / decay, 1, 0.01);
  RecordProperty("ratio", std::to_string(measured / decay));
}

INSTANTIATE_TEST_SUITE_P(AlphaAndBeta, SheetDecay,
                         testing::Values(structure::Rayleigh{0.05, 0}, structure::Rayleigh{0, 0.05},
                                         structure::Rayleigh{0.03, 0.03}));

}  // namespace
}  // namespace velum::tests
