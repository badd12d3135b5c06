#include "ibm/sheet_hydrostatic.hpp"

#include <cmath>
#include <utility>

namespace velum::ibm {

SheetRegions find_regions(structure::Sheet const& sheet, contact::PointContact const& contact,
                          RegionSeeds const& seeds)
{
  auto const places = node_places(sheet.position);
  std::vector<double> pressing(places.size());
  for (std::size_t a = 0; a < places.size(); ++a)
    pressing[a] = contact::pressing(contact, a, places[a]);
  return find_regions(sheet.triangles, std::move(pressing), seeds);
}

SheetHydrostaticReport hydrostatic_equilibrium(
    structure::Sheet& sheet, std::shared_ptr<contact::PointContact> const& contact,
    RegionSeeds const& seeds, std::vector<structure::Load> loads, HydrostaticLoad const& load,
    bool augment)
{
  constexpr int max_updates = 60;
  constexpr int patience = 10;  // updates after which the pressure goes half as far each
  SheetHydrostaticReport report;
  loads.push_back(structure::pressure_load(sheet, report.pressure));
  loads.push_back(contact_load(contact));
  report.regions = find_regions(sheet, *contact, seeds);
  for (; report.updates < max_updates; ++report.updates) {
    structure::CornerPressure const pressure =
        pressure_by_region(sheet, sheet.position, report.regions, load);
    // A node at the land's edge moves that edge by a whole triangle as soon as it presses by a
    // little, which lifts it off again: only small steps find the place between.
    double const share = std::ldexp(1.0, -report.updates / patience);
    if (report.updates == 0) report.pressure = pressure;
    report.pressure += share * (pressure - report.pressure);
    Eigen::VectorXd const before = sheet.position;
    report.iterations += structure::static_solve(sheet, loads).iterations;
    report.moved = (sheet.position - before).cwiseAbs().maxCoeff();
    auto const places = node_places(sheet.position);
    report.regions = find_regions(sheet, *contact, seeds);
    report.contact = contact::sum_up(*contact, places);
    double const change = augment ? contact::update_multipliers(*contact, places) : 0;
    // only now the offsets: regions and multipliers belong to those the solve was made with
    follow_thickness(*contact, sheet);
    bool const still = report.moved < 1e-8 * share * sheet.reference.cwiseAbs().maxCoeff() &&
                       change < 1e-6 * shear_modulus(sheet.material);
    if (report.updates > 0 && still) break;
  }
  return report;
}

}  // namespace velum::ibm
