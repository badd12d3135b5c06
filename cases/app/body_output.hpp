#pragma once
#include "cases/app/body_model.hpp"
#include "cases/app/body_run.hpp"
#include "core/output/fields.hpp"
#include "core/output/series.hpp"

namespace velum::cases {

/// Files that grow by a state.
struct BodyOutput {
  core::FieldsFile fields;
  core::Series series, profile;
};

BodyOutput start_output(BodyScene const& scene, std::filesystem::path const& folder);

/// Adds a state, numbered from 1: a row of series.csv, the deformed body, and its section z = 0 on
/// the side y >= 0 to profile.csv.
template <class Body>
void record(BodyOutput& out, BodyModel<Body> const& model, BodyState const& state, int number);

}  // namespace velum::cases
