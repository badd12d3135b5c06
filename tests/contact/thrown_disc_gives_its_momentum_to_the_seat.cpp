// problem:   a free, undamped rubber disc of 5 mm and 0.5 mm thickness, of lines about the axis
//            and of triangles, thrown flat at 2 m/s at a round ring of 3 mm, until it is on its way
//            back; penalty four times the one that stops it within half its thickness; explicit
//            sub-steps, and implicit steps of a fortieth of the bounce
// reference: balance of momentum: the disc's mass times its change of velocity is what the seat
//            pushed; conservation of energy
// measure:   sum of the seat's impulses against the change of momentum along the axis, over the
//            momentum thrown; energy (kinetic, elastic, of the contact) over that at first, at each
//            step, velocities taken half a sub-step on to where the places are; depth; the change
//            of momentum of both schemes
// tolerance: impulse 1e-12; energy grows by 1e-4 at most and is off by 5e-4 at the end,
//            the implicit scheme's grows by 5e-4; depth 0.5 H; schemes 0.3 %
// why:       forces of the rubber have no sum: only rounding is left. The explicit scheme is the
//            leapfrog, second order: 2e-4 seen at the end, no growth; the implicit one damps what
//            it does not resolve (2 %). Four times the stiffness stops a free face at 0.25 H, here
//            the rubber beside the ring pushes too: 0.38 H. Schemes were 0.18 % apart, 0.05 % with
//            half the step; those of triangles, which buckle in their plane as they come back, more
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/safe_step.hpp"
#include "ibm/contact_march.hpp"
#include "structure/internal_force.hpp"
#include "structure/mass.hpp"
#include "structure/sheet_force.hpp"
#include "structure/sheet_mesh.hpp"

namespace velum::tests {
namespace {

constexpr double H = 0.5e-3, radius = 5e-3, density = 1140, mu = 1e6, speed = 2;
constexpr double R = 3e-3, section = 0.25e-3;  // of the ring

double stiffness() { return 4 * contact::stopping_stiffness(density * H, speed, H / 2); }

/// A body thrown, and its seat.
template <class Body, class Seat>
struct Thrown {
  Body body;
  std::shared_ptr<Seat> seat;
};

template <class Body>
Body thrown(Body body)
{
  for (Eigen::Index i = 0; i < body.velocity.size(); i += Body::dimension)
    body.velocity[i] = -speed;
  return body;
}

Thrown<structure::Membrane, ibm::SeatContact> line()
{
  auto m = thrown(structure::flat_membrane({.symmetry = core::Symmetry::axisymmetric,
                                            .from = 0,
                                            .to = radius,
                                            .element_size = radius / 40,
                                            .thickness = [](double) { return H; },
                                            .material = structure::neo_hookean_rubber(mu),
                                            .density = density}));
  m.fixed[m.fixed.size() - 2] = m.fixed.back() = 0;
  auto const ring = core::disc({-section - 0.6 * H, R}, section);
  return {m, std::make_shared<ibm::SeatContact>(ibm::make_seat_contact(ring, stiffness(), m))};
}

Thrown<structure::Sheet, contact::PointContact> sheet()
{
  auto s = thrown(structure::make_sheet(structure::disc_mesh(structure::graded(0, radius, 12)), H,
                                        structure::neo_hookean_rubber(mu), density));
  auto const ring = [](core::Vec3 const& X) {
    return std::hypot(std::hypot(X[1], X[2]) - R, X[0] + section + 0.6 * H) - section;
  };
  return {s,
          std::make_shared<contact::PointContact>(ibm::make_sheet_contact(s, ring, stiffness()))};
}

template <class Body>
double along_axis(Eigen::VectorXd const& of_nodes)
{
  double sum = 0;
  for (Eigen::Index i = 0; i < of_nodes.size(); i += Body::dimension) sum += of_nodes[i];
  return sum;
}

double stored(ibm::SeatContact& c, Eigen::VectorXd const& x)
{
  press(c, x);
  double sum = 0;
  for (std::size_t a = 0; a < c.markers.X.size(); ++a) {
    double const g = std::min(0.0, contact::gap(c.contact, c.markers, a));
    sum += 0.5 * c.contact.stiffness * c.markers.area[a] * g * g;
  }
  return sum;
}
double stored(contact::PointContact const& c, Eigen::VectorXd const& x)
{
  double sum = 0;
  auto const places = ibm::node_places(x);
  for (std::size_t a = 0; a < places.size(); ++a) {
    double const g = std::min(0.0, c.solid(places[a]) - c.offset[a]);
    sum += 0.5 * c.stiffness * c.area[a] * g * g;
  }
  return sum;
}

/// @param ahead  half of an explicit sub-step, by which its velocities lag behind the places
template <class Body, class Seat>
double energy(Thrown<Body, Seat> const& t, Eigen::VectorXd const& mass, double ahead)
{
  Eigen::VectorXd force = Eigen::VectorXd::Zero(t.body.position.size());
  structure::add_elastic_force(t.body, t.body.position, force);
  ibm::contact_load(t.seat)(t.body.position, force, nullptr);
  double sum =
      structure::elastic_energy(t.body, t.body.position) + stored(*t.seat, t.body.position);
  for (Eigen::Index i = 0; i < force.size(); ++i) {
    double const m = mass[i / Body::dimension];
    sum += 0.5 * m * std::pow(t.body.velocity[i] + ahead * force[i] / m, 2);
  }
  return sum;
}

/// Momenta over the one thrown; energies over the first, less 1.
struct Bounce {
  double impulse = 0, momentum = 0, deepest = 0, most_energy = 0, last_energy = 0;
};

template <class Body, class Seat, class Stepper>
Bounce bounce(Thrown<Body, Seat> t, Stepper stepper)
{
  constexpr double step = 20e-6;
  Eigen::VectorXd const mass = structure::lumped_mass(t.body);
  double const thrown = mass.sum() * speed, first = energy(t, mass, 0);
  Bounce b;
  for (int n = 0; n < 40; ++n) {
    auto const taken = ibm::advance_in_contact(stepper, t.body, t.seat, step, {});
    if (taken.impulse.size() > 0) b.impulse += along_axis<Body>(taken.impulse) / thrown;
    b.deepest = std::max(b.deepest, taken.penetration);
    double const ahead = taken.iterations > 0 ? 0 : step / taken.substeps / 2;
    b.last_energy = energy(t, mass, ahead) / first - 1;
    b.most_energy = std::max(b.most_energy, b.last_energy);
  }
  for (Eigen::Index a = 0; a < mass.size(); ++a)
    b.momentum += mass[a] * (t.body.velocity[Body::dimension * a] + speed) / thrown;
  return b;
}

/// @param least  momentum that the seat gives, of that thrown
template <class Thrown>
void expect_bounces(Thrown const& t, double least)
{
  auto const b = bounce(t, structure::explicit_stepper(t.body, {}));
  EXPECT_GT(b.momentum, least);
  EXPECT_NEAR(b.impulse, b.momentum, 1e-12);
  EXPECT_LT(b.most_energy, 1e-4);
  EXPECT_NEAR(b.last_energy, 0, 5e-4);
  EXPECT_LT(b.deepest, 0.5 * H);
}

TEST(ThrownDisc, of_lines_gives_its_momentum_to_the_ring_and_keeps_its_energy)
{
  expect_bounces(line(), 1.5);
}

TEST(ThrownDisc, of_triangles_gives_its_momentum_to_the_ring_and_keeps_its_energy)
{
  expect_bounces(sheet(), 1.3);
}

TEST(ThrownDisc, comes_back_alike_in_implicit_steps)
{
  auto const t = line();
  auto const sub = bounce(t, structure::explicit_stepper(t.body, {}));
  auto const b = bounce(t, structure::implicit_stepper(t.body, {}));
  EXPECT_NEAR(b.momentum / sub.momentum, 1, 0.003);
  EXPECT_LT(b.most_energy, 5e-4);
  EXPECT_LT(b.deepest, 0.5 * H);
}

// In one step of 2 ms the disc would fly 4 mm, past the ring: the implicit scheme cuts it.
TEST(ThrownDisc, is_met_by_the_ring_in_a_step_that_flies_past_it)
{
  auto const t = line();
  auto m = t.body;
  auto implicit = structure::implicit_stepper(m, {});
  auto const step = ibm::advance_in_contact(implicit, m, t.seat, 2e-3, {});
  EXPECT_GT(step.substeps, 10);
  EXPECT_GT(step.force, 0);
  EXPECT_LT(step.penetration, 0.5 * H);
}

}  // namespace
}  // namespace velum::tests
