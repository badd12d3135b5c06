#pragma once
#include "contact/augmented_lagrangian.hpp"
#include "contact/lip_pressure.hpp"
#include "contact/patch.hpp"
#include "ibm/contact_load.hpp"
#include "structure/pressure_load.hpp"
#include "structure/static_solve.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace velum::tests {

/// A membrane and the seat under its minus side.
struct PressedMembrane {
  structure::Membrane membrane;
  std::shared_ptr<ibm::SeatContact> seat;
};

inline PressedMembrane pressed(structure::Membrane membrane, core::Obstacle const& seat,
                               double stiffness)
{
  auto contact =
      std::make_shared<ibm::SeatContact>(ibm::make_seat_contact(seat, stiffness, membrane));
  ibm::press(*contact, membrane.position);
  return {std::move(membrane), std::move(contact)};
}

/// Pressure `inside` on the part of the minus face before the patch, `outside` after it, what the
/// lip option says between; plus face: `above` everywhere. Breaks lie where the patch ends, inside
/// elements too; node a is marker a.
inline structure::FacePressure pressure_by_region(PressedMembrane const& s,
                                                  contact::Patch const& patch,
                                                  contact::LipPressure lip, double above,
                                                  double inside, double outside)
{
  using structure::Side;
  auto pressure = structure::uniform_pressure(s.membrane, Side::plus, above);
  auto at = [&](double place, double middle) {
    if (middle < patch.begin) return inside;
    if (middle > patch.end) return outside;
    return contact::face_pressure(lip, std::clamp(place, patch.begin, patch.end), patch.begin,
                                  patch.end, inside, outside);
  };
  auto add = [&](int e, double from, double to) {
    double const middle = e + 0.5 * (from + to);
    if (to > from)
      pressure.push_back({e, Side::minus, from, to, at(e + from, middle), at(e + to, middle)});
  };
  for (int e = 0; e < element_count(s.membrane); ++e) {
    double const a = std::clamp(patch.begin - e, 0.0, 1.0), b = std::clamp(patch.end - e, 0.0, 1.0);
    add(e, 0, a), add(e, a, b), add(e, b, 1);
  }
  return pressure;
}

struct PressedReport {
  contact::Patch patch;
  structure::FacePressure pressure;
  int iterations = 0;
  int updates = 0;
};

/// Static equilibrium under the given further loads and pressures: augmented Lagrangian when
/// `augment`, plain penalty else; repeated until contact patch, thickness and multipliers stand.
inline PressedReport settle(PressedMembrane& s, std::vector<structure::Load> loads,
                            contact::LipPressure lip, double above, double inside, double outside,
                            bool augment, int max_updates = 60)
{
  PressedReport r;
  loads.push_back(structure::pressure_load(s.membrane, r.pressure));
  loads.push_back(ibm::contact_load(s.seat));
  auto& contact = s.seat->contact;
  auto const& markers = s.seat->markers;
  r.patch = contact::contact_patch(contact, markers);
  for (; r.updates < max_updates; ++r.updates) {
    r.pressure = pressure_by_region(s, r.patch, lip, above, inside, outside);
    Eigen::VectorXd const before = s.membrane.position;
    r.iterations += structure::static_solve(s.membrane, loads).iterations;
    double const moved = (s.membrane.position - before).cwiseAbs().maxCoeff();
    r.patch = contact::contact_patch(contact, markers);
    double const change = augment ? contact::update_multipliers(contact, markers) : 0;
    // Only now the offsets: patch and multipliers belong to those the solve was made with.
    ibm::follow_thickness(*s.seat, s.membrane);
    double const scale = s.membrane.shear_modulus;
    if (r.updates > 0 && moved < 1e-9 * s.membrane.reference.maxCoeff() && change < 1e-6 * scale)
      break;
  }
  return r;
}

}  // namespace velum::tests
