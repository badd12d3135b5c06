#include "ibm/hydrostatic.hpp"

#include <algorithm>

#include "contact/augmented_lagrangian.hpp"

namespace velum::ibm {

structure::FacePressure pressure_by_region(structure::Membrane const& membrane,
                                           contact::Patch const& patch, HydrostaticLoad const& load)
{
  using structure::Side;
  auto pressure = structure::uniform_pressure(membrane, Side::plus, load.above);
  if (!contact::touches(patch)) {
    auto const below = structure::uniform_pressure(membrane, Side::minus, load.outside);
    pressure.insert(pressure.end(), below.begin(), below.end());
    return pressure;
  }
  auto const at = [&](double place, double middle) {
    if (middle < patch.begin) return load.inside;
    if (middle > patch.end) return load.outside;
    return contact::face_pressure(load.lip, std::clamp(place, patch.begin, patch.end), patch.begin,
                                  patch.end, load.inside, load.outside);
  };
  auto const add = [&](int e, double from, double to) {
    double const middle = e + 0.5 * (from + to);
    if (to > from)
      pressure.push_back({e, Side::minus, from, to, at(e + from, middle), at(e + to, middle)});
  };
  for (int e = 0; e < structure::element_count(membrane); ++e) {
    double const a = std::clamp(patch.begin - e, 0.0, 1.0);
    double const b = std::clamp(patch.end - e, 0.0, 1.0);
    add(e, 0, a);
    add(e, a, b);
    add(e, b, 1);
  }
  return pressure;
}

HydrostaticReport hydrostatic_equilibrium(structure::Membrane& membrane,
                                          std::shared_ptr<SeatContact> const& seat,
                                          std::vector<structure::Load> loads,
                                          HydrostaticLoad const& load, bool augment)
{
  constexpr int max_updates = 60;
  HydrostaticReport report;
  loads.push_back(structure::pressure_load(membrane, report.pressure));
  loads.push_back(contact_load(seat));
  press(*seat, membrane.position);
  report.patch = contact::contact_patch(seat->contact, seat->markers);
  for (; report.updates < max_updates; ++report.updates) {
    report.pressure = pressure_by_region(membrane, report.patch, load);
    Eigen::VectorXd const before = membrane.position;
    report.iterations += structure::static_solve(membrane, loads).iterations;
    double const moved = (membrane.position - before).cwiseAbs().maxCoeff();
    press(*seat, membrane.position);
    report.patch = contact::contact_patch(seat->contact, seat->markers);
    double const change = augment ? contact::update_multipliers(seat->contact, seat->markers) : 0;
    // only now the offsets: patch and multipliers belong to those the solve was made with
    follow_thickness(*seat, membrane);
    bool const still = moved < 1e-9 * membrane.reference.maxCoeff() &&
                       change < 1e-6 * shear_modulus(membrane.material);
    if (report.updates > 0 && still) break;
  }
  return report;
}

}  // namespace velum::ibm
