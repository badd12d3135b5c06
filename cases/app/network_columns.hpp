#pragma once
#include <vector>

#include "cases/app/pressure_network.hpp"
#include "core/output/series.hpp"

namespace velum::cases {

/// Columns of a series: the regions' pressures and the membrane on its seat, then its own, then
/// pressure of each chamber, flow and lift of each orifice.
std::vector<core::Column> valve_columns(Scene const& scene, std::vector<core::Column> const& own);

/// Values now of those of chambers and orifices, SI.
std::vector<double> network_row(ibm::Network const& network, NetworkKey const& key,
                                Scene const& scene, Derived const& derived, double time);

}  // namespace velum::cases
