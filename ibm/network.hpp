#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ibm/loss.hpp"
#include "structure/enclosure.hpp"

namespace velum::ibm {

/// A volume of liquid at one pressure, less that of the rest state.
struct Chamber {
  double compliance;  ///< volume at rest / bulk modulus: volume stored per pressure
  double pressure = 0;
  double content = 0;  ///< volume of liquid at rest density that it holds beyond its volume at rest
  double swept = 0;    ///< its volume beyond that at rest: what a body has swept
};

/// A place whose pressure is given: a boundary, or a port of the lattice.
struct Port {
  double pressure = 0;
  /// Pressure that a flow into the port raises there at once: rho c / area of a lattice port, whose
  /// sound carries it away. `pressure` holds at the flow `at_flow`.
  double impedance = 0;
  double at_flow = 0;
  double flow = 0;  ///< into the port, mean of the last step
};

/// Passage between two nodes. Nodes are numbered through: the chambers, then the ports.
struct Passage {
  int from, to;
  std::optional<Loss> loss;  ///< empty: shut
  double inertance = 0;      ///< rho length / area: pressure per rate of the flow
  double flow = 0;           ///< mean of the last step, towards `to`
};

/// Chambers joined by passages, their pressures found together with what a body sweeps. Any
/// consistent set of units.
struct Network {
  std::vector<Chamber> chambers;
  std::vector<Port> ports;
  std::vector<Passage> passages;
};

/// What a linear passage does in a step: Q = conductance (p_from - p_to) + constant.
struct LinearFlow {
  double conductance = 0, constant = 0;
};

/// Each passage about its present state: without inertance about the flow that the present
/// pressures drive, with it about the present flow, backward Euler:
///   inertance (Q' - Q) / h + viscous Q' + inertial (2 |Q| Q' - |Q| Q) = p'_from - p'_to.
/// A port's impedance acts like friction.
std::vector<LinearFlow> linearised(Network const& network, double h);

/// What a body that sweeps the chambers feels of the network in a step.
/// @param area  of each chamber: derivative of its volume by the positions   [dN][chambers]
structure::Enclosures enclosures(Network const& network, std::vector<LinearFlow> const& flows,
                                 Eigen::MatrixXd area);

/// Takes over a step of length h: volumes from what the body swept, flows from the mean pressures,
/// contents from the flows, pressures from contents and volumes,
///   swept += h A^T vbar,   content += h (what flowed in),   p = (content - swept) / compliance,
/// so that no liquid is lost however far the body moved. A chamber of no compliance keeps the
/// pressure that the step found.
/// @param velocity  of the body, mean of the step [dN]
void take_over(Network& network, std::vector<LinearFlow> const& flows,
               structure::Enclosures const& after, Eigen::VectorXd const& velocity, double h);

/// Contents that go with the present pressures and volumes.
void fill(Network& network);

/// Pressure of a node.
double pressure(Network const& network, int node);

}  // namespace velum::ibm
