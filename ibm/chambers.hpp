#pragma once
#include <optional>
#include <vector>

#include "ibm/network.hpp"
#include "ibm/seat_gap.hpp"
#include "lbm/opening.hpp"
#include "structure/membrane.hpp"

namespace velum::ibm {

/// Openings of the lattice, all of one port of the network, and which port that is.
struct LatticePort {
  std::vector<std::size_t> openings;
  int port;
  /// What the port takes for its pressure: that of the cells before it in the place of the
  /// traction. What passes the staircase of a gap's edge is uneven, and a traction less rho U^2
  /// keeps the momentum of the unevenness.
  bool of_cells = false;
};

/// Flow through the membrane's own gap where a law stands in for the lattice: a passage between two
/// ports, whose openings are the edges of the gap, outside and within. What comes to the edge from
/// upstream brings its velocity head along: the law's loss is less by rho Q^2 / (2 area^2).
struct GapFlow {
  GapLaw law;
  int passage;
  std::size_t opening[2];  // outside, inside
  SeatGap gap{};           // of the step under way
};

/// Lumped chambers and orifices around a lattice: a chamber may lie on the plus side of the
/// membrane, where then no lattice fluid is, and passages may end in openings of the lattice.
struct Chambers {
  Network network;
  int above = -1;  // chamber on the plus side, or -1
  std::vector<LatticePort> ports;
  std::optional<GapFlow> gap;
  std::vector<LinearFlow> flows;  // of the step under way
  structure::Enclosures enclosed;
};

/// Whether a gap flow is in use: its edges are in the lattice and fluid can pass between them.
bool passes(Chambers const& c);

/// Volume that went through the gap by its law in the last step, inwards.
/// @pre there is a gap flow
double gap_flow(Chambers const& c);

/// Before the membrane's step: the ports take the pressure that was measured there, the mean of
/// two steps (at the lattice's own period of two its answer to velocity is too large), and what the
/// membrane will feel of the chambers is made ready. A port's impedance is that of a plane wave
/// into the lattice, rho c / area.
/// @param seat  looked at where there is a gap flow
void begin_step(Chambers& c, std::vector<lbm::Opening>& openings,
                structure::Membrane const& membrane, SeatContact const* seat);

/// After it: flows, contents and pressures of the chambers; the openings of the ports are given the
/// flows for the fluid's next step, so that what leaves the network enters the lattice to the last
/// digit, one step later.
/// @param velocity  mean of the step [2N]
void end_step(Chambers& c, std::vector<lbm::Opening> const& openings, std::vector<double>& targets,
              Eigen::VectorXd const& velocity);

}  // namespace velum::ibm
