#pragma once
#include <filesystem>

#include "core/output/series.hpp"
#include "structure/membrane.hpp"

namespace velum::cases {

/// Starts profile.csv of a folder: the shape of a membrane, a row for each node and time.
core::Series start_profile(std::filesystem::path const& folder);

/// Adds the nodes of the mid-surface and of the minus face, and the thickness, at a time in s.
/// @param dx  length of a lattice unit, m
void append_profile(core::Series& profile, structure::Membrane const& membrane, double dx,
                    double time);

}  // namespace velum::cases
