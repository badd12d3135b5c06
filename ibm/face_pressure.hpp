#pragma once
#include <Eigen/Core>
#include <vector>

#include "contact/lip_pressure.hpp"
#include "contact/patch.hpp"
#include "core/obstacle.hpp"
#include "ibm/sharp.hpp"

namespace velum::ibm {

/// Pressure on both faces, node by node, and the load of what the links do not see.
///
/// Links feel a face of steps, half a thickness away from the mid-surface; under a film there are
/// none. The load that belongs to a membrane without stress across its thickness is the pressure on
/// the area A of its mid-surface: equal pressures on the two faces, whose areas differ where the
/// membrane is curved, must cancel, for an incompressible solid between them takes them without
/// strain. Every node therefore gets  p (A - L)  on top of its link forces, L being the summed area
/// of its links and p the mean normal stress on them, on its neighbours' where it has none, or the
/// film's.
/// The mean runs over some steps, for only the link forces are coupled implicitly.
struct FacePressure {
  contact::LipPressure lip = contact::LipPressure::linear;
  std::vector<double> p[2];   // plus and minus face, less that of the rest state   [N]
  std::vector<char> film[2];  // 1 where the face is nearer than half a cell to a wall [N]
  bool started = false;
};

/// Where the faces have films in place of fluid.
struct Film {
  core::Obstacle const& walls;  // nearer than half a cell to one
  core::Obstacle seat;          // nearer than seat_width to it: minus face only
  double seat_width;
  std::vector<double> outside_share;  // of the pressure difference there [N]; empty: half
};

/// Steps over which the pressure of the faces is averaged.
constexpr double pressure_memory = 1;

/// Area vectors of a line of nodes as seen from its plus or minus side, pointing into the membrane:
/// a pressure p on that side gives the force p A.  [N]
std::vector<core::Vec2> face_area(std::vector<core::Vec2> const& line, bool plus,
                                  core::Symmetry symmetry);

/// Updates the pressures from the links and adds the missing load to the force.
/// @param patch  of the contact with the seat; may be empty
void complete_load(FacePressure& pressure, Exchange& exchange, Surface const& surface,
                   Film const& film, core::Symmetry symmetry, contact::Patch const& patch);

}  // namespace velum::ibm
