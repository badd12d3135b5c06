#pragma once
#include "cases/app/body_model.hpp"
#include "cases/app/body_run.hpp"
#include "cases/app/material_range.hpp"
#include "core/output/fields.hpp"
#include "core/output/series.hpp"

namespace velum::cases {

/// Files that grow by a state.
struct BodyOutput {
  core::FieldsFile fields;
  core::Series series, profile;
};

BodyOutput start_output(BodyScene const& scene, std::filesystem::path const& folder);

/// The model's present state under a pressure; what is stretched goes into the record.
/// @param iterations  linear solves that it took
template <class Body>
BodyState state_of(BodyScene const& scene, BodyModel<Body> const& model, double pressure,
                   int iterations, StretchRecord& stretch);

/// Adds a state, by its number from 1 or its time: a row of series.csv, the deformed body, and its
/// section z = 0 on the side y >= 0 to profile.csv.
template <class Body>
void record(BodyOutput& out, BodyModel<Body> const& model, BodyState const& state, double at);

}  // namespace velum::cases
