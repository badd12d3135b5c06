#pragma once
#include <optional>
#include <vector>

#include "cases/app/pressure_network.hpp"
#include "core/output/series.hpp"
#include "structure/lift_stop.hpp"

namespace velum::cases {

/// Columns of a series: the regions' pressures and the membrane on its seat, then its own, then
/// pressure of each chamber, flow and lift of each orifice, force of the lift stop.
std::vector<core::Column> valve_columns(Scene const& scene, std::vector<core::Column> const& own);

/// Adds the force of the stop, where there is one, N.
void add_stop(std::vector<double>& row, std::optional<structure::LiftStop> const& stop,
              structure::Membrane const& membrane, Derived const& derived);

/// Values now of those of chambers and orifices, SI.
std::vector<double> network_row(ibm::Network const& network, NetworkKey const& key,
                                Scene const& scene, Derived const& derived, double time);

}  // namespace velum::cases
