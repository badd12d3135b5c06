// problem:   vibrations across of a disc of line elements about the axis: a membrane, stretched
//            alike in all directions and clamped; a plate, clamped and hinged, not stretched; and a
//            strip in the plane, stretched along, between two held edges
// reference: membrane omega = j/a sqrt(T/(rho h)), j = 2.404826 and 5.520078, T the tension per
//            length and rho h the mass per area of the stretched state; plate omega = s/a^2
//            sqrt(D/(rho H)), D = mu H^3/3, s = 10.2158 and 39.771 clamped (Leissa, Vibration of
//            Plates, NASA SP-160 (1969), table 2.1), hinged the first root of J1/J0 + I1/I0 =
//            2 s^(1/2) / (1 - nu) (same, section 2.1.2), nu = 1/2; strip omega = pi/b sqrt(T/(rho
//            h))
// measure:   relative error of the root of the eigenvalue, stiffness against lumped mass; slope of
//            the error over 10, 20, 40 elements
// tolerance: 1 % with 40 elements; order 2 +- 0.2
// why:       linear elements, slopes by differences and lumped mass are second order: 40 elements
//            err by some 0.1 % in the first and 0.5 % in the second vibration
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <vector>

#include "structure/line_bending.hpp"
#include "structure/mass.hpp"
#include "structure/total_stiffness.hpp"
#include "tests/support/order.hpp"

namespace velum::structure {
namespace {

constexpr double mu = 1e6, H = 1e-3, a = 0.02, density = 1100;

Membrane flat(core::Symmetry symmetry, int elements)
{
  return flat_membrane(
      {symmetry, 0, a, a / elements, [](double) { return H; }, neo_hookean_rubber(mu), density});
}

/// The slowest frequencies of motion along the axis; a flat state couples no other to it.
Eigen::VectorXd frequencies_across(Membrane const& m, std::span<Load const> loads)
{
  std::vector<int> place(static_cast<std::size_t>(2 * node_count(m)), -1);
  int free = 0;
  for (int i = 0; i < 2 * node_count(m); i += 2)
    if (!m.fixed[static_cast<std::size_t>(i)]) place[static_cast<std::size_t>(i)] = free++;
  Eigen::VectorXd const mass = lumped_mass(m);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(free, free);
  for (auto const& t : total_stiffness(m, m.position, loads)) {
    int const row = place[static_cast<std::size_t>(t.row())];
    int const column = place[static_cast<std::size_t>(t.col())];
    if (row < 0 || column < 0) continue;
    K(row, column) += t.value() / std::sqrt(mass[t.row() / 2] * mass[t.col() / 2]);
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseSqrt();
}

/// First and second frequency over the reference's.
Eigen::Vector2d stretched_disc(double l, int elements)
{
  Membrane m = flat(core::Symmetry::axisymmetric, elements);
  m.position *= l;
  double const speed = std::sqrt(mu * (1 - std::pow(l, -6)) * l * l / density);
  Eigen::VectorXd const omega = frequencies_across(m, {}) * l * a / speed;
  return {omega[0] / 2.404826, omega[1] / 5.520078};
}

Eigen::Vector2d plate(Rim rim, Eigen::Vector2d const& root, int elements)
{
  Membrane const m = flat(core::Symmetry::axisymmetric, elements);
  auto const bending = line_bending(m, rim);
  Load const load = bending_load(bending);
  Eigen::VectorXd const omega =
      frequencies_across(m, {&load, 1}) * a * a / std::sqrt(mu * H * H / 3 / density);
  return omega.head<2>().cwiseQuotient(root);
}

Eigen::Vector2d clamped_plate(int elements)
{
  return plate(Rim::clamped, {10.2158, 39.771}, elements);
}

TEST(LineFrequency, of_a_stretched_membrane)
{
  for (double l : {1.05, 1.5}) {
    auto const ratio = stretched_disc(l, 40);
    EXPECT_NEAR(ratio[0], 1, 0.01) << l;
    EXPECT_NEAR(ratio[1], 1, 0.01) << l;
    RecordProperty("first_" + std::to_string(l), std::to_string(ratio[0]));
    RecordProperty("second_" + std::to_string(l), std::to_string(ratio[1]));
  }
}

TEST(LineFrequency, of_a_clamped_plate)
{
  auto const ratio = clamped_plate(40);
  EXPECT_NEAR(ratio[0], 1, 0.01);
  EXPECT_NEAR(ratio[1], 1, 0.01);
  RecordProperty("first", std::to_string(ratio[0]));
  RecordProperty("second", std::to_string(ratio[1]));
}

/// Root k of the frequency equation of a hinged plate, nu = 1/2; s = k^2.
double hinged_root()
{
  auto const missing = [](double k) {
    return std::cyl_bessel_j(1, k) / std::cyl_bessel_j(0, k) +
           std::cyl_bessel_i(1, k) / std::cyl_bessel_i(0, k) - 2 * k / (1 - 0.5);
  };
  double low = 2.0, high = 2.39;  // below the first zero of J0, where it runs to infinity
  while (high - low > 1e-12) {
    double const middle = (low + high) / 2;
    (missing(middle) < 0 ? low : high) = middle;
  }
  return low;
}

TEST(LineFrequency, of_a_hinged_plate)
{
  double const k = hinged_root();
  double const ratio = plate(Rim::hinged, {k * k, 1}, 40)[0];
  EXPECT_NEAR(ratio, 1, 0.01);
  RecordProperty("first", std::to_string(ratio));
}

TEST(LineFrequency, of_a_strip_stretched_along)
{
  constexpr double l = 1.3;
  Membrane m = flat(core::Symmetry::planar, 40);
  m.position *= l;
  // sigma = mu (l^2 - l^-2), the same volume: density as it was
  double const speed = std::sqrt(mu * (l * l - 1 / (l * l)) / density);
  EXPECT_NEAR(frequencies_across(m, {})[0] * l * a / speed / std::numbers::pi, 1, 0.01);
}

TEST(LineFrequency, is_second_order_in_the_size_of_elements)
{
  std::vector<double> size, membrane, bent;
  for (int n : {10, 20, 40}) {
    size.push_back(1.0 / n);
    membrane.push_back(std::abs(stretched_disc(1.2, n)[0] - 1));
    bent.push_back(std::abs(clamped_plate(n)[0] - 1));
  }
  RecordProperty("order_membrane", std::to_string(tests::order(size, membrane)));
  RecordProperty("order_plate", std::to_string(tests::order(size, bent)));
  EXPECT_NEAR(tests::order(size, membrane), 2, 0.2);
  EXPECT_NEAR(tests::order(size, bent), 2, 0.2);
}

}  // namespace
}  // namespace velum::structure
