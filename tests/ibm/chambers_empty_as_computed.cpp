// problem:    a lumped chamber empties through a passage with friction, with inertia, with both of
// a
//             column; a rigid piston closes it; a membrane sweeps it
// reference:  p = p0 exp(-t/(C R)); sqrt(p) = sqrt(p0) - t/(2 C sqrt K); frequency of a column,
//             1/sqrt(I C); of a piston of mass M and area A, A/sqrt(C M)
// measure:    pressure over time, frequency, order in the step, what the network holds in all
// tolerance:  order 1 +- 0.15 (backward Euler); contents 1e-12 of what flowed; frequency 0.5 %
// why:        backward Euler damps what it resolves with 400 steps to a period by pi/400 of the
//             logarithm each and shifts the frequency by (pi/400)^2; sums are exact but for
//             rounding
#include "ibm/network.hpp"
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/mass.hpp"
#include "structure/pressure_load.hpp"
#include "tests/support/order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace velum::ibm {
namespace {

/// A body that nothing moves: the network alone.
structure::Membrane still()
{
  auto m = structure::flat_membrane({core::Symmetry::planar, 0, 1, 1, [](double) { return 1.0; },
                                     structure::neo_hookean_rubber(1), 1});
  m.fixed.assign(m.fixed.size(), 1);
  return m;
}

struct Alone {
  structure::Membrane body = still();
  structure::ExplicitStepper stepper = structure::explicit_stepper(body, {});

  void step(Network& network, double h)
  {
    auto const n = static_cast<Eigen::Index>(network.chambers.size());
    auto const flows = linearised(network, h);
    auto enclosed = enclosures(network, flows, Eigen::MatrixXd::Zero(body.position.size(), n));
    Eigen::VectorXd const none = Eigen::VectorXd::Zero(body.position.size());
    auto const& velocity = structure::advance(stepper, body, none, {}, h, 1, {}, &enclosed);
    take_over(network, flows, enclosed, velocity, h);
  }
};

Network tank(double compliance, Loss const& loss, double inertance = 0)
{
  Network network{{{compliance, 1, 0}}, {{}}, {{0, 1, loss, inertance}}};
  fill(network);
  return network;
}

double left_after(Network network, double time, int steps)
{
  Alone alone;
  for (int n = 0; n < steps; ++n) alone.step(network, time / steps);
  return network.chambers[0].pressure;
}

TEST(Chamber, empties_through_friction_and_through_an_orifice)
{
  std::vector<double> h, friction, head;
  for (int const steps : {50, 100, 200, 400}) {
    h.push_back(1.0 / steps);
    friction.push_back(std::abs(left_after(tank(0.5, {2, 0}), 1, steps) - std::exp(-1.0)));
    double const exact = std::pow(1 - 0.5 / (2 * 0.5 * std::sqrt(2.0)), 2);
    head.push_back(std::abs(left_after(tank(0.5, {1e-9, 2}), 0.5, steps) - exact));
  }
  EXPECT_NEAR(tests::order(h, friction), 1, 0.15);
  EXPECT_NEAR(tests::order(h, head), 1, 0.15);
  EXPECT_LT(friction.back(), 1e-3);
  EXPECT_LT(head.back(), 1e-3);
}

/// Time between the first and third passage of zero.
template <class Step>
double period(Step&& step, double h)
{
  double before = step(), t = h, first = 0;
  for (int crossings = 0;;) {
    double const now = step();
    t += h;
    if ((before > 0) != (now > 0)) {
      double const at = t - h * now / (now - before);
      if (++crossings == 1) first = at;
      if (crossings == 3) return at - first;
    }
    before = now;
  }
}

TEST(Chamber, a_column_of_liquid_swings_on_it)
{
  double const I = 3, C = 0.2, T = 2 * std::numbers::pi * std::sqrt(I * C), h = T / 400;
  auto network = tank(C, {1e-6, 0}, I);
  Alone alone;
  double const found =
      period([&] { return alone.step(network, h), network.chambers[0].pressure; }, h);
  EXPECT_NEAR(found, T, 5e-3 * T);
}

TEST(Chamber, nothing_is_lost_between_chambers_and_ports)
{
  Network network{{{0.3, 5, 0}, {0.1, 0, 0}, {0.2, -1, 0}},
                  {{2.0}, {0.0, 0.5}},
                  {{0, 1, Loss{1, 2}},
                   {1, 2, Loss{3, 0.1}, 0.7},
                   {3, 0, Loss{2, 1}},
                   {2, 4, Loss{0.1, 4}, 0.1},
                   {0, 2, std::nullopt}}};
  fill(network);
  auto const content = [&] {
    return network.chambers[0].content + network.chambers[1].content + network.chambers[2].content;
  };
  Alone alone;
  double const before = content();
  double out = 0, size = 0;
  for (int n = 0; n < 300; ++n) {
    alone.step(network, 0.01);
    out += 0.01 * (network.ports[0].flow + network.ports[1].flow);
    size += 0.01 * std::abs(network.ports[1].flow);
    EXPECT_EQ(network.passages[4].flow, 0);
  }
  EXPECT_NEAR(content() + out, before, 1e-12 * size);
}

struct Piston {
  structure::Membrane body;
  structure::ExplicitStepper stepper;
  Eigen::MatrixXd area;
};

/// A strip of unit width that moves as one.
Piston piston()
{
  auto m = structure::flat_membrane({core::Symmetry::planar, 0, 1, 0.1, [](double) { return 0.5; },
                                     structure::neo_hookean_rubber(1), 4});
  for (int a = 0; a < structure::node_count(m); ++a) m.fixed[2 * a] = 0, m.fixed[2 * a + 1] = 1;
  Eigen::VectorXd force = Eigen::VectorXd::Zero(m.position.size());
  structure::pressure_load(m, structure::uniform_pressure(m, structure::Side::plus, 1))(
      m.position, force, nullptr);
  Piston p{m, structure::explicit_stepper(m, {}), force};
  return p;
}

/// The piston swings on a chamber with its period, by whatever advances it: a function of body,
/// step and enclosed volumes that returns the mean velocity.
template <class Advance>
void expect_swings(Advance&& advance)
{
  double const M = 2, C = 0.05, T = 2 * std::numbers::pi * std::sqrt(C * M), h = T / 400;
  auto p = piston();
  Network network{{{C, 1, 0}}, {}, {}};
  fill(network);
  auto const step = [&] {
    auto const flows = linearised(network, h);
    auto enclosed = enclosures(network, flows, p.area);
    Eigen::VectorXd const velocity = advance(p, h, enclosed);
    double const inside = enclosed.pressure[0];
    take_over(network, flows, enclosed, velocity, h);
    EXPECT_NEAR(network.chambers[0].pressure, inside, 1e-12);
    return network.chambers[0].pressure;
  };
  EXPECT_NEAR(period(step, h), T, 5e-3 * T);
}

TEST(Chamber, a_piston_swings_on_it_at_any_number_of_sub_steps)
{
  for (int const substeps : {1, 4})
    expect_swings([&](Piston& p, double h, structure::Enclosures& enclosed) {
      Eigen::VectorXd const none = Eigen::VectorXd::Zero(p.body.position.size());
      return structure::advance(p.stepper, p.body, none, {}, h, substeps, {}, &enclosed);
    });
}

TEST(Chamber, a_piston_swings_on_it_in_implicit_steps_too)
{
  for (double const rho_inf : {1.0, 0.5}) {
    auto stepper = structure::implicit_stepper(piston().body, {}, rho_inf);
    expect_swings([&](Piston& p, double h, structure::Enclosures& enclosed) {
      Eigen::VectorXd const none = Eigen::VectorXd::Zero(p.body.position.size());
      structure::advance(stepper, p.body, none, {}, h, {}, &enclosed);
      return stepper.mean;
    });
  }
}

TEST(Chamber, an_incompressible_one_that_is_shut_holds_the_piston)
{
  auto p = piston();
  p.body.velocity.setZero();
  Network network{{{0, 0, 0}}, {{7}}, {{0, 1, Loss{1e12, 0}}}};
  Eigen::VectorXd const load = -10 * p.area.col(0);
  auto const flows = linearised(network, 0.01);
  auto enclosed = enclosures(network, flows, p.area);
  structure::advance(p.stepper, p.body, load, {}, 0.01, 3, {}, &enclosed);
  EXPECT_LT(p.body.velocity.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(enclosed.pressure[0], 10, 1e-9);
}

}  // namespace
}  // namespace velum::ibm
