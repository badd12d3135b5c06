#pragma once
#include <string>
#include <vector>

#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"
#include "ibm/network.hpp"

namespace velum::cases {

/// The chambers and orifices of a scene as a network in lattice units. Its chambers are those of
/// the scene, in their order, then `regions` more; its ports are the boundaries with a pressure or
/// of kind "port", by name; its passages are the scene's orifices, in their order.
struct NetworkKey {
  std::vector<std::string> port;  // name of each
  std::vector<Curve> lift;        // of each orifice's gap over the movement of its member, m; empty
                                  // where the member is rigid
  int above = -1;                 // chamber on the plus side of the membrane
  int inlet = -1, outlet = -1;    // ports of that name, if there are any
};
struct PressureNetwork {
  ibm::Network network;
  NetworkKey key;  // what in it is what of the scene
};

/// @param regions  chambers to add, of no compliance and no pressure
/// Throws core::Divergence where a pilot membrane has no equilibrium.
PressureNetwork make_network(Scene const& scene, Derived const& derived, int regions = 0);

/// Opening of an orifice's seat at a time, m.
double lift_at(OrificeSection const& orifice, Curve const& lift, double time);

/// Sets the ports to the pressures of their boundaries, and the orifices to their lifts, at a time.
/// @param shut  nothing comes in through the inlet
void set_network(ibm::Network& network, NetworkKey const& key, Scene const& scene,
                 Derived const& derived, double time, bool shut);

}  // namespace velum::cases
