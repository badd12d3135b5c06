#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cases/app/hydrostatic_scene.hpp"
#include "cases/app/lattice_scene.hpp"
#include "cases/app/pressure_network.hpp"
#include "ibm/diffuse.hpp"
#include "ibm/step.hpp"

namespace velum::cases {

/// The parts of the fluid that a seat can part: above the membrane, below it outside the seat, and
/// below it inside.
enum class Zone { none, above, outside, inside };

/// A scene ready to march, lattice units.
template <class Real, template <class> class Body>
struct CoupledScene {
  Derived derived;
  ibm::Coupled<Real, Body> state;
  std::vector<std::string> boundary;  // of each opening
  NetworkKey key;                     // of the chambers
  std::vector<int> driven;            // nodes of the membrane that are moved as given
  std::optional<structure::LiftStop> stop{};
  double divide = std::numeric_limits<double>::infinity();  // radius of the seat, cells; without
                                                            // one all is inside

  Zone zone(std::uint8_t side, int j) const
  {
    // a diffuse membrane has fluid between its faces, which belongs to neither side
    if (side == 0 || side == ibm::inside) return Zone::none;
    if (side == ibm::plus_side) return Zone::above;
    return state.fluid.origin[1] + j + 0.5 < divide ? Zone::inside : Zone::outside;
  }
};

/// Joins fluid and membrane; the membrane is where `hydrostatic` has it, the fluid at rest under
/// the pressure of each zone's opening.
template <class Real, template <class> class Body>
CoupledScene<Real, Body> make_coupled_scene(Scene const& scene, HydrostaticScene const& hydrostatic,
                                            double smagorinsky);

/// Sets the targets of the openings for a time (s); from `shut` on the inlets let nothing through.
template <class Real, template <class> class Body>
void set_targets(CoupledScene<Real, Body>& s, Scene const& scene, double time, bool shut);

/// Gives the driven nodes the velocity that takes them, in the step that ends at this time (s), to
/// where the scene wants them.
template <class Real, template <class> class Body>
void drive(CoupledScene<Real, Body>& s, Scene const& scene, double time);

/// Mean pressure of a zone less that of the rest state, lattice units; 0 where it has no cell.
template <class Real, template <class> class Body>
double mean_pressure(CoupledScene<Real, Body> const& s, Zone zone);

}  // namespace velum::cases
