#pragma once
#include <optional>
#include <string>

#include "cases/app/driven_record.hpp"
#include "cases/app/measurement.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// What a closed valve has to show. SI units.
struct Certificate {
  double inlet = 0, outlet = 0;  // pressures imposed
  Measurement settled, shut;     // at the end of either stage
  Measurement window_begin;      // leak and balance are taken from here to `settled`
  double least_jump_shut = 0;    // over the stage with the inlet shut, Pa
  double centre_hydrostatic = 0, centre_start = 0;
  double stretch_max = 0;
  double penetration_max = 0, speed_max = 0, mach_max = 0;
  double eddy_mean = 0, eddy_max = 0;  // m2/s
  double wall_time = 0, mlups = 0;
  double membrane_share = 0;  // of the wall time
  bool has_shut = false;
  std::optional<DrivenRecord> driven{};  // in place of what a closed valve shows
};

/// Flow through the seat that the certificate compares leaks with: the paper's 200 l/h at 3 bar.
constexpr double open_flow = 200e-3 / 3600;

std::vector<core::Figure> figures(Certificate const& c);

/// The certificate as a table for people.
std::string certificate_text(Certificate const& c);

}  // namespace velum::cases
