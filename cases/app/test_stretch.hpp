#pragma once
#include "cases/app/test_columns.hpp"

namespace velum::cases {

/// The stretch of each row of test data, from its column "stretch" or "strain".
/// @throws core::InputError  it is not positive, beyond any rubber, does not spread or turns back
std::vector<double> read_stretch(TestColumns const& data);

}  // namespace velum::cases
