#include "ibm/contact_march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check.hpp"
#include "ibm/contact_step.hpp"

namespace velum::ibm {
namespace {

constexpr int looks_every = 10;     // sub-steps, after which their length is found anew
constexpr double most_parts = 1e7;  // of a step

/// Equal parts of what is left that are no longer than the longest.
int parts(double left, double longest)
{
  double const n = std::ceil(left / longest - 1e-9);
  if (!(n <= most_parts))
    throw core::Divergence(
        fmt::format("the body moves so fast that it may take sub-steps of {:.3g} at most towards "
                    "its seat",
                    longest));
  return std::max(1, static_cast<int>(n));
}

std::vector<structure::Load> with(std::span<structure::Load const> loads, structure::Load one)
{
  std::vector<structure::Load> all(loads.begin(), loads.end());
  all.push_back(std::move(one));
  return all;
}

double stiffness(SeatContact const& c) { return c.contact.stiffness; }
double stiffness(contact::PointContact const& c) { return c.stiffness; }
std::vector<double> const& areas(SeatContact const& c) { return c.markers.area; }
std::vector<double> const& areas(contact::PointContact const& c) { return c.area; }

/// Notes the forces of the seat, which is plain penalty: a force is k times area times depth.
template <int d, class Seat>
void note(ContactSteps& steps, Seat const& seat, Eigen::VectorXd const& force)
{
  auto const& area = areas(seat);
  double carried = 0;
  for (std::size_t a = 0; a < area.size(); ++a) {
    auto const f = force.segment<d>(d * static_cast<Eigen::Index>(a));
    carried += f[0];
    steps.penetration = std::max(steps.penetration, f.norm() / (stiffness(seat) * area[a]));
  }
  steps.force = std::max(steps.force, std::abs(carried));
}

}  // namespace

template <class Body, class Seat>
ContactSteps advance_in_contact(structure::ExplicitStepper& s, Body& m,
                                std::shared_ptr<Seat> const& seat, double dt,
                                std::span<structure::Load const> loads)
{
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(m.position.size());
  ContactSteps steps;
  steps.impulse = none;
  Eigen::VectorXd force = none, sum = none;
  auto const touch = contact_load(seat);
  auto const all = with(
      loads, [&](Eigen::VectorXd const& x, Eigen::VectorXd& total, structure::Triplets* tangent) {
        force.setZero();
        touch(x, force, tangent);
        note<Body::dimension>(steps, *seat, force);
        total += force;
        sum += force;
      });
  for (double left = dt; left > 0;) {
    int const needed = parts(left, contact_step(m, s.mass, *seat, loads));
    int const now = std::min(needed, looks_every);
    double const h = left / needed;
    sum.setZero();
    structure::advance(s, m, none, {}, now * h, now, all);
    steps.impulse += h * sum;
    steps.substeps += now;
    left = now == needed ? 0 : left - now * h;
  }
  return steps;
}

template <class Body, class Seat>
ContactSteps advance_in_contact(structure::ImplicitStepper& s, Body& m,
                                std::shared_ptr<Seat> const& seat, double dt,
                                std::span<structure::Load const> loads)
{
  ContactSteps steps;
  auto const all = with(loads, contact_load(seat));
  Eigen::VectorXd force;
  double longest = dt;
  for (double left = dt; left > 0;) {
    int const needed = parts(left, std::min(longest, safe_step(*seat, m.position, m.velocity)));
    double const h = left / needed;
    Eigen::VectorXd const x = m.position, v = m.velocity, a = s.acceleration;
    steps.iterations += structure::advance(s, m, h, all).iterations;
    if (safe_step(*seat, x, m.position - x, 1.0) < 1) {
      m.position = x, m.velocity = v, s.acceleration = a;
      longest = h / 2;
      continue;
    }
    force.setZero(x.size());
    all.back()(m.position, force, nullptr);
    note<Body::dimension>(steps, *seat, force);
    ++steps.substeps;
    longest = dt;
    left = needed == 1 ? 0 : left - h;
  }
  return steps;
}

template ContactSteps advance_in_contact(structure::ExplicitStepper&, structure::Membrane&,
                                         std::shared_ptr<SeatContact> const&, double,
                                         std::span<structure::Load const>);
template ContactSteps advance_in_contact(structure::ExplicitStepper&, structure::Sheet&,
                                         std::shared_ptr<contact::PointContact> const&, double,
                                         std::span<structure::Load const>);
template ContactSteps advance_in_contact(structure::ImplicitStepper&, structure::Membrane&,
                                         std::shared_ptr<SeatContact> const&, double,
                                         std::span<structure::Load const>);
template ContactSteps advance_in_contact(structure::ImplicitStepper&, structure::Sheet&,
                                         std::shared_ptr<contact::PointContact> const&, double,
                                         std::span<structure::Load const>);

}  // namespace velum::ibm
