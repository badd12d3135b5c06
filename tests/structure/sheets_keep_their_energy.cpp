// problem:   clamped disc of triangles let go without damping, a membrane stretched by 1.2 and a
//            plate with bending: small from its slowest mode, large from 0.3 of the radius (plate:
//            0.1, half its thickness); by symplectic Euler and by generalised-alpha
// reference: symplectic Euler keeps v^2 + w^2 x^2 - h w^2 x v of a mode of frequency w exactly: its
//            energy swings by w h/2 to either side, and E + h/2 F.v does not (Hairer, Lubich,
//            Wanner, Geometric Numerical Integration (2006), I.1.2 and IX.8); generalised-alpha
//            with rho_inf = 1 is the midpoint rule, which keeps the energy of a linear motion; with
//            rho_inf < 1 a mode decays by the spectral radius of the scheme's 3 x 3 matrix (Chung
//            and Hulbert, J. Appl. Mech. 60 (1993) 371), 1 - O((w h)^3)
// measure:   half the range of the energy over its mean; slope of the line fitted over 100 periods,
//            times that time, over the mean: of E + h/2 F.v, of E by the implicit scheme; large:
//            the standard deviation of E at h and h/2 over 20 periods; loss of energy in a period
// tolerance: range within 1 % of w h/2, drift 1e-6 small; large: drift 1e-3, ratio 2 +- 0.1;
//            implicit drift 1e-6; loss within 2 % of the matrix's, order 3 +- 0.1
// why:       a small motion is the mode alone up to amplitude^2; in a large one energy goes to and
//            fro between many modes, each with a swing of its own w h/2, and E + h/2 F.v swings
//            by O(h^2), which a line through it may catch by chance; Newton leaves 1e-9
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/restrained.hpp"
#include "structure/stable_step.hpp"
#include "tests/structure/vibrating_disc.hpp"
#include "tests/support/order.hpp"

namespace velum::tests {
namespace {

/// What a series of energies does in time.
struct Swing {
  double range;      ///< half of largest less smallest, over the mean
  double deviation;  ///< root of the mean square about the mean, over the mean
  double drift;      ///< slope of the fitted line times the whole time, over the mean
};

void record(DiscKind kind, std::string const& name, double value)
{
  testing::Test::RecordProperty((kind == DiscKind::plate ? "plate_" : "membrane_") + name,
                                fmt::format("{:.6g}", value));
}

Swing swing(std::vector<double> const& series)
{
  Eigen::Map<Eigen::ArrayXd const> const y(series.data(), static_cast<Eigen::Index>(series.size()));
  Eigen::ArrayXd const t = Eigen::ArrayXd::LinSpaced(y.size(), -0.5, 0.5);
  double const mean = y.mean();
  return {(y.maxCoeff() - y.minCoeff()) / 2 / mean, std::sqrt((y - mean).square().mean()) / mean,
          (t * y).sum() / t.square().sum() / mean};
}

struct EulerSwing {
  Swing of_energy, of_modified;  ///< E, and E + h/2 F.v
  double omega_h;                ///< of the slowest mode
};

/// @param share  of the stable step
EulerSwing by_symplectic_euler(DiscKind kind, double amplitude, double share, int periods)
{
  constexpr int between = 5;  // steps from one sample to the next
  auto d = vibrating_disc(kind, 3, amplitude);
  auto const loads = d.loads();
  auto stepper = structure::explicit_stepper(d.sheet, {});
  double const h = share * structure::stable_step(d.sheet, stepper.mass, d.sheet.position, loads);
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(d.sheet.position.size());
  std::vector<double> plain, modified;
  for (int n = 0; n < periods * d.period / (between * h); ++n) {
    structure::advance(stepper, d.sheet, none, {}, between * h, between, loads);
    Eigen::VectorXd force = none;
    for (auto const& load : loads) load(d.sheet.position, force, nullptr);
    structure::add_elastic_force(d.sheet, d.sheet.position, force);
    structure::drop_fixed(d.sheet.fixed, force);
    plain.push_back(energy(d, stepper.mass));
    modified.push_back(plain.back() + h / 2 * force.dot(d.sheet.velocity));
  }
  return {swing(plain), swing(modified), d.mode.omega * h};
}

TEST(SheetEnergy, swings_by_half_of_omega_h_under_symplectic_euler)
{
  for (auto kind : {DiscKind::membrane, DiscKind::plate}) {
    auto const s = by_symplectic_euler(kind, 1e-3, 0.8, 100);
    EXPECT_NEAR(s.of_energy.range / (s.omega_h / 2), 1, 0.01);
    EXPECT_LT(std::abs(s.of_modified.drift), 1e-6);
    record(kind, "range_over_half_omega_h", s.of_energy.range / (s.omega_h / 2));
    record(kind, "drift", s.of_modified.drift);
  }
}

TEST(SheetEnergy, does_not_drift_in_a_large_motion_under_symplectic_euler)
{
  for (auto kind : {DiscKind::membrane, DiscKind::plate}) {
    double const amplitude = kind == DiscKind::plate ? 0.1 : 0.3;
    auto const lasting = by_symplectic_euler(kind, amplitude, 0.5, 100);
    EXPECT_LT(std::abs(lasting.of_modified.drift), 1e-3);
    auto const coarse = by_symplectic_euler(kind, amplitude, 0.5, 20);
    auto const fine = by_symplectic_euler(kind, amplitude, 0.25, 20);
    EXPECT_NEAR(coarse.of_energy.deviation / fine.of_energy.deviation, 2, 0.1);
    record(kind, "range", lasting.of_energy.range);
    record(kind, "drift", lasting.of_modified.drift);
    record(kind, "ratio", coarse.of_energy.deviation / fine.of_energy.deviation);
  }
}

std::vector<double> by_generalised_alpha(DiscKind kind, double rho_inf, int steps, int periods)
{
  auto d = vibrating_disc(kind, 3, 1e-3);
  auto const loads = d.loads();
  Eigen::VectorXd const mass = structure::lumped_mass(d.sheet);
  auto stepper = structure::implicit_stepper(d.sheet, {}, rho_inf);
  std::vector<double> series{energy(d, mass)};
  for (int n = 0; n < steps * periods; ++n) {
    structure::advance(stepper, d.sheet, d.period / steps, loads);
    series.push_back(energy(d, mass));
  }
  return series;
}

TEST(SheetEnergy, of_a_small_motion_is_kept_by_the_implicit_scheme)
{
  for (auto kind : {DiscKind::membrane, DiscKind::plate}) {
    auto const s = swing(by_generalised_alpha(kind, 1, 8, 100));
    EXPECT_LT(std::abs(s.drift), 1e-6);
    EXPECT_LT(s.range, 1e-5);
    record(kind, "drift", s.drift);
    record(kind, "range", s.range);
  }
}

/// Modulus of the two complex eigenvalues of a step of generalised-alpha for x'' = -w^2 x, on
/// (x, h v, h^2 a), with w h = z.
double decay_per_step(double rho_inf, double z)
{
  double const am = (2 * rho_inf - 1) / (rho_inf + 1), af = rho_inf / (rho_inf + 1);
  double const gamma = 0.5 - am + af, beta = 0.25 * (1 - am + af) * (1 - am + af);
  Eigen::Matrix3d ahead, now;
  ahead << 1, 0, -beta, 0, 1, -gamma, (1 - af) * z * z, 0, 1 - am;
  now << 1, 1, 0.5 - beta, 0, 1, 1 - gamma, -af * z * z, 0, -am;
  return (ahead.inverse() * now).eigenvalues().cwiseAbs().maxCoeff();
}

TEST(SheetEnergy, is_lost_with_the_third_power_of_the_step_where_fast_modes_are_damped)
{
  std::vector<double> size, lost;
  for (int steps : {20, 40, 80}) {
    constexpr int periods = 3;
    auto const series = by_generalised_alpha(DiscKind::membrane, 0.5, steps, periods);
    double const z = 2 * std::numbers::pi / steps;
    double const expected = -2 * std::log(decay_per_step(0.5, z)) * steps;
    // from the first to the last whole period
    double const loss =
        -std::log(series.back() / series[static_cast<std::size_t>(steps)]) / (periods - 1);
    EXPECT_NEAR(loss / expected, 1, 0.02) << steps;
    record(DiscKind::membrane, fmt::format("loss_over_expected_{}", steps), loss / expected);
    size.push_back(z);
    lost.push_back(loss);
  }
  record(DiscKind::membrane, "order", order(size, lost));
  EXPECT_NEAR(order(size, lost), 3, 0.1);
}

}  // namespace
}  // namespace velum::tests
