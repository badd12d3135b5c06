#pragma once
#include "cases/app/curve.hpp"

#include <optional>
#include <string>

/// Lumped chambers and orifices of a scene. SI units.
namespace velum::cases {

/// Which side of the membrane a chamber is on, if any.
enum class ChamberSide { none, above };

/// A volume of liquid at one pressure.
struct ChamberSection {
  std::string name;
  ChamberSide side = ChamberSide::none;
  double volume;                    // with the membrane flat
  double bulk_modulus = 2.2e9;      // of the liquid and what gives way around it
  std::optional<double> initial{};  // pressure; empty: that of the inlet
};

/// An elastic disc, clamped at its rim, whose middle is moved: the lift over a seat between middle
/// and rim is a share of the middle's.
struct PilotMembrane {
  std::string material;
  double radius;    // of its rim
  double boss;      // out to this radius it is moved as one
  Curve thickness;  // over the radius
};

/// A seat ring that a valve member lifts off: a gap in series with its orifice.
struct LiftedSeat {
  double diameter, land;  // of the ring, and its width along the flow
  double discharge = 0.7;
  Curve lift{};  // of the gap over time; of an elastic member: that of its centre
};

/// A passage between two chambers, boundaries or ports, named.
struct OrificeSection {
  std::string name, from, to;
  double area;
  double discharge = 0.7;
  double transition = 30;  // Reynolds number at which friction and inertia take the same share
  double length = 0;       // of the column of liquid whose inertia counts
  std::optional<LiftedSeat> seat{};
  std::optional<PilotMembrane> member{};
};

/// Closure of the membrane's own seat where no lattice resolves it, and, without a lattice, the
/// columns of liquid between it and the openings.
struct GapSection {
  double cells = 0;  // below this width a lattice leaves the gap to the closure; 0: resolves it
  double discharge = 0.7;
  double seals_at = 1e-6;
  double inlet_length = 0, outlet_length = 0;
};

}  // namespace velum::cases
