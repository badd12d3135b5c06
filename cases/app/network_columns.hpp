#pragma once
#include <vector>

#include "cases/app/pressure_network.hpp"
#include "core/output/series.hpp"

namespace velum::cases {

/// Columns of a series: pressure of each chamber, flow and lift of each orifice.
std::vector<core::Column> network_columns(Scene const& scene);

/// Their values now, SI.
std::vector<double> network_row(ibm::Network const& network, NetworkKey const& key,
                                Scene const& scene, Derived const& derived, double time);

}  // namespace velum::cases
