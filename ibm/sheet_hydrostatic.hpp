#pragma once
#include <memory>
#include <vector>

#include "ibm/region_pressure.hpp"
#include "ibm/sheet_contact.hpp"
#include "structure/static_solve.hpp"

namespace velum::ibm {

struct SheetHydrostaticReport {
  SheetRegions regions;
  contact::ContactSum contact;
  structure::CornerPressure pressure;  // of the last solve
  int iterations = 0;                  // linear solves of all Newton solves
  int updates = 0;                     // of regions, thickness and multipliers
  double moved = 0;                    // the farthest that the last update moved a node
};

/// Regions below a sheet at its present position.
SheetRegions find_regions(structure::Sheet const& sheet, contact::PointContact const& contact,
                          RegionSeeds const& seeds);

/// Moves a sheet to static equilibrium under the region pressures, the contact of its minus side
/// and the further loads, as hydrostatic_equilibrium() does a membrane of lines: `outside` is
/// upstream, `inside` downstream. Solved again until regions, thickness and, with augment, the
/// multipliers stand still, 60 times at most (report.moved tells).
/// Throws core::Divergence where there is no equilibrium.
SheetHydrostaticReport hydrostatic_equilibrium(
    structure::Sheet& sheet, std::shared_ptr<contact::PointContact> const& contact,
    RegionSeeds const& seeds, std::vector<structure::Load> loads, HydrostaticLoad const& load,
    bool augment);

}  // namespace velum::ibm
