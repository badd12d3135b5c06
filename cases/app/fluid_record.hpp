#pragma once
#include <filesystem>
#include <optional>

#include "cases/app/fluid_scene.hpp"
#include "cases/app/history.hpp"
#include "core/output/fields.hpp"
#include "lbm/observe.hpp"

namespace velum::cases {

/// What a run without a membrane keeps and writes: a row per sample (largest speed, flow and
/// traction of every opening, the probes) and the fields per dump.
struct FluidRecord {
  History history;
  std::optional<core::Series> series;      // empty: nothing is written
  std::optional<core::FieldsFile> fields;  // the same
};

/// @param out  folder of the results; empty: nothing is written
template <class Real, class L, class Stored>
FluidRecord start_record(FluidScene<Real, L, Stored> const& s, std::filesystem::path const& out,
                         core::Assumptions const& about);

/// Adds a row for the state at a time, s.
template <class Real, class L, class Stored>
void add_sample(FluidRecord& record, FluidScene<Real, L, Stored>& s, lbm::Observation const& seen,
                double time);

/// Writes the fields at a time, s.
template <class Real, class L, class Stored>
void add_dump(FluidRecord& record, FluidScene<Real, L, Stored> const& s, double time);

}  // namespace velum::cases
