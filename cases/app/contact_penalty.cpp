#include "cases/app/contact_penalty.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>

#include "ibm/sheet_contact.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/static_solve.hpp"

namespace velum::cases {
namespace {

constexpr double radius = 8.25e-3, thickness = 1e-3, shear = 0.946e6, pressure = 50e3;
constexpr double seat_radius = 5.25e-3, section = 0.25e-3, clearance = 0.05e-3;
constexpr double settled = 1e-6;  // change of the multipliers over the pressure

/// Distance from the ring; its axis is x.
double ring(core::Vec3 const& X)
{
  double const place = -thickness / 2 - section - clearance;
  return std::hypot(std::hypot(X[1], X[2]) - seat_radius, X[0] - place) - section;
}

struct Solution {
  contact::ContactSum sum;
  int solves = 0, iterations = 0;
};

/// @param updates  of the multipliers at most; 0: plain penalty
Solution pressed(int rings, double stiffness, int updates)
{
  auto const mesh = structure::disc_mesh(structure::graded(0, radius, rings));
  auto sheet = structure::make_sheet(mesh, thickness, structure::neo_hookean_rubber(shear), 1140);
  for (int n : structure::rim_points(mesh)) structure::clamp(sheet, n);
  Eigen::VectorXd const load = Eigen::VectorXd::Constant(element_count(sheet), pressure);
  auto const seat =
      std::make_shared<contact::PointContact>(ibm::make_sheet_contact(sheet, ring, stiffness));
  std::array const loads{structure::pressure_load(sheet, load), ibm::contact_load(seat)};
  Solution s;
  auto const solve = [&] {
    s.iterations += structure::static_solve(sheet, loads).iterations;
    ++s.solves;
  };
  solve();
  for (int n = 0; n < updates; ++n) {
    if (contact::update_multipliers(*seat, ibm::node_places(sheet.position)) < settled * pressure)
      break;
    solve();
  }
  s.sum = contact::sum_up(*seat, ibm::node_places(sheet.position));
  return s;
}

}  // namespace

void contact_penalty(int rings, int per_decade, std::function<void(PenaltyRow const&)> const& found)
{
  constexpr int updates = 100;
  auto const exact = pressed(rings, 2e11, updates).sum;
  for (bool const augmented : {false, true})
    for (int n = 0; n <= 3 * per_decade; ++n) {
      double const k = 1e9 * std::pow(10, double(n) / per_decade);
      auto const s = pressed(rings, k, augmented ? updates : 0);
      found({augmented ? "augmented_lagrangian" : "penalty", k, s.sum.penetration, s.sum.force[0],
             std::abs(s.sum.force[0] / exact.force[0] - 1), s.sum.largest,
             std::abs(s.sum.largest / exact.largest - 1), s.solves, s.iterations});
    }
}

std::string csv(std::vector<PenaltyRow> const& rows)
{
  std::string text =
      "method,stiffness [Pa/m],penetration [m],seat_force [N],seat_force_error,"
      "largest_pressure [Pa],largest_pressure_error,solves,linear_solves\n";
  for (auto const& r : rows)
    text += fmt::format("{},{:.4g},{:.4g},{:.9g},{:.4g},{:.9g},{:.4g},{},{}\n", r.method,
                        r.stiffness, r.penetration, r.seat_force, r.force_error, r.largest,
                        r.largest_error, r.solves, r.iterations);
  return text;
}

}  // namespace velum::cases
