// problem:    first in-plane mode of a clamped planar strip, small amplitude, Rayleigh damping
// reference:  u = exp(-d t) cos(w t) sin(pi Y/L), w^2 = w0^2 - d^2, d = (alpha + beta w0^2)/2,
//             w0 = (pi/L) sqrt(4 mu/rho): plane strain of incompressible rubber has modulus 4 mu
// measure:    decay rate and frequency from the least-squares fit through the zero crossings and
//             peaks of the mode's amplitude; explicit and implicit scheme
// tolerance:  1 % of the rate, 0.5 % of the frequency
// why:        40 elements: 0.03 % in w0; the explicit scheme is first order: w0 dt = 0.008 here
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/membrane.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>
#include <numbers>
#include <vector>

namespace velum::structure {
namespace {

constexpr double mu = 2, rho = 3, length = 1;
double const omega0 = std::numbers::pi / length * std::sqrt(4 * mu / rho);

Membrane plucked()
{
  auto m = flat_membrane({core::Symmetry::planar, 0, length, length / 40,
                          [](double) { return 0.1; }, neo_hookean_rubber(mu), rho});
  for (int a = 0; a < node_count(m); ++a)
    m.position[2 * a + 1] += 1e-6 * std::sin(std::numbers::pi * m.reference[2 * a + 1] / length);
  return m;
}

double amplitude(Membrane const& m)
{
  double sum = 0;
  for (int a = 0; a < node_count(m); ++a)
    sum += (m.position[2 * a + 1] - m.reference[2 * a + 1]) *
           std::sin(std::numbers::pi * m.reference[2 * a + 1] / length);
  return sum;
}

struct Fit {
  double decay, omega;
};

/// From equal samples q_n: q_n+1 + e^-2dh q_n-1 = 2 e^-dh cos(wh) q_n, solved by least squares over
/// samples a tenth of a period apart.
Fit fit(std::vector<double> const& q, double h)
{
  Eigen::MatrixXd rows(q.size() - 2, 2);
  Eigen::VectorXd right(q.size() - 2);
  for (std::size_t n = 1; n + 1 < q.size(); ++n) {
    rows.row(n - 1) << q[n], -q[n - 1];
    right[n - 1] = q[n + 1];
  }
  Eigen::Matrix2d const normal = rows.transpose() * rows;
  Eigen::Vector2d const c = normal.inverse() * (rows.transpose() * right);
  double const decay = -0.5 * std::log(c[1]) / h;
  return {decay, std::acos(0.5 * c[0] * std::exp(decay * h)) / h};
}

template <class Advance>
Fit observe(Membrane& m, Advance advance_once)
{
  int const per_sample = 80, samples = 60;
  double const period = 2 * std::numbers::pi / omega0, dt = period / (10 * per_sample);
  std::vector<double> q{amplitude(m)};
  for (int s = 0; s < samples; ++s) {
    for (int n = 0; n < per_sample; ++n) advance_once(dt);
    q.push_back(amplitude(m));
  }
  return fit(q, per_sample * dt);
}

class RayleighDecay : public testing::TestWithParam<Rayleigh> {};

TEST_P(RayleighDecay, is_that_of_the_mode)
{
  auto const damping = GetParam();
  double const decay = 0.5 * (damping.alpha + damping.beta * omega0 * omega0);
  double const omega = std::sqrt(omega0 * omega0 - decay * decay);

  auto m = plucked();
  auto explicit_one = explicit_stepper(m, damping);
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
  auto const a = observe(m, [&](double dt) { advance(explicit_one, m, none, {}, dt, 1, {}); });
  EXPECT_NEAR(a.decay, decay, 0.01 * decay);
  EXPECT_NEAR(a.omega, omega, 0.005 * omega);

  m = plucked();
  auto implicit_one = implicit_stepper(m, damping);
  auto const b = observe(m, [&](double dt) { advance(implicit_one, m, dt, {}); });
  EXPECT_NEAR(b.decay, decay, 0.01 * decay);
  EXPECT_NEAR(b.omega, omega, 0.005 * omega);
}

INSTANTIATE_TEST_SUITE_P(AlphaAndBeta, RayleighDecay,
                         testing::Values(Rayleigh{0.1 * omega0, 0}, Rayleigh{0, 0.1 / omega0},
                                         Rayleigh{0.05 * omega0, 0.05 / omega0}));

}  // namespace
}  // namespace velum::structure
