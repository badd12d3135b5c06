#pragma once
#include <filesystem>

#include "cases/app/measurement.hpp"
#include "core/output/fields.hpp"
#include "core/output/series.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// Files that grow while fluid and membrane march.
struct CoupledOutput {
  core::FieldsFile fields;
  core::Series series;
  double next_dump = 0;  // s
};

/// Starts run.h5, run.xmf and series.csv.
CoupledOutput start_output(Scene const& scene, Derived const& derived,
                           core::Assumptions const& said, std::filesystem::path const& folder);

/// Goes on with those of an earlier run where `out` was: what they hold of later times is dropped.
/// Fields that the end of the earlier run has left damaged are begun anew, with a warning.
/// @param out  dumps and rows that count, times of the index, next dump
CoupledOutput resume_output(CoupledOutput out, Scene const& scene, Derived const& derived,
                            core::Assumptions const& said, std::filesystem::path const& folder);

/// Adds a row, and the fields where their time has come.
template <class Real, template <class> class Body>
void record(CoupledOutput& out, CoupledScene<Real, Body> const& s, Measurement const& m,
            double output_every);

}  // namespace velum::cases
