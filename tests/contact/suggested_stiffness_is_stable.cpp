// problem:    a loose strip falls on a flat seat under pressure, explicit steps, penalty contact
// reference:  energy: an elastic bounce cannot gain any; the suggested k = rho h / (4 dt^2)
// measure:    speed after the bounce over the speed at impact, penetration against the step
// tolerance:  speed within 10 %; 400 times the stiffness must be unstable or gain energy
// why:        omega dt = 1/2: symplectic Euler bounces back within omega dt / 2 of the speed at
//             worst; at omega dt = 10 the limit 2 is passed by far
#include "contact/contact.hpp"
#include "contact/penalty.hpp"
#include "structure/explicit_step.hpp"
#include "structure/mass.hpp"
#include "structure/membrane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velum::tests {
namespace {

double speed_after_bounce(double factor)
{
  double const dt = 0.01, thickness = 0.1, density = 3, speed = 0.01;
  auto m = structure::flat_membrane({core::Symmetry::planar, 0, 1, 0.1,
                                     [=](double) { return thickness; },
                                     structure::neo_hookean_rubber(0.05), density, 0.0525});
  std::fill(m.fixed.begin(), m.fixed.end(), 0);
  for (int a = 0; a < node_count(m); ++a) m.velocity[2 * a] = -speed;
  double const k = factor * contact::stable_stiffness(density * thickness, dt);
  contact::Contact const seat{core::box({-1, -5}, {0, 5}), k, {}};
  auto const area = structure::nodal_area(m);
  structure::Load const contact_load = [&](Eigen::VectorXd const& x, Eigen::VectorXd& force,
                                           structure::Triplets*) {
    core::Markers markers;
    for (int a = 0; a < node_count(m); ++a) {
      markers.X.push_back(structure::node(x, a));
      markers.F.push_back({});
      markers.area.push_back(area[a]);
      markers.offset.push_back(0.5 * thickness);
    }
    contact::add_forces(seat, markers);
    for (int a = 0; a < node_count(m); ++a)
      for (int d = 0; d < 2; ++d) force[2 * a + d] += markers.F[a][d];
  };
  auto stepper = structure::explicit_stepper(m, {});
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
  for (int n = 0; n < 100; ++n)
    structure::advance(stepper, m, none, {}, dt, 1, std::span(&contact_load, 1));
  return m.velocity[0] / speed;
}

TEST(SuggestedStiffness, bounces_without_gaining_energy)
{
  EXPECT_NEAR(speed_after_bounce(1), 1, 0.1);
  double const beyond = speed_after_bounce(400);
  EXPECT_TRUE(!(std::abs(beyond) < 1.5)) << beyond;
}

}  // namespace
}  // namespace velum::tests
