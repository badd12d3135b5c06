#pragma once
#include <string>
#include <vector>

#include "cases/app/measurement.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// What a membrane whose middle is moved as given does to the fluid below it. SI units.
struct DrivenRecord {
  double start = 0;         // place of the middle at rest
  double lift = 0;          // of the middle, the farthest
  double volume_start = 0;  // below the membrane
  double mass_start = 0;    // of fluid there, over its rest density
  double swept = 0;         // volume that the lower face has swept, the largest
  double misfit = 0;        // largest |what came in less what the fluid there gained|
  double static_shape = 0;  // swept at the end over that of the body at rest, less 1
};

DrivenRecord start_record(Measurement const& m);
void note(DrivenRecord& record, Measurement const& m);

/// centre_displacement, swept_volume, displaced_volume_error (of the largest swept one) and
/// shape_error.
std::vector<core::Figure> figures(DrivenRecord const& record);

/// The record as a table for people.
std::string record_text(DrivenRecord const& record);

}  // namespace velum::cases
