#pragma once
#include "cases/app/body_scene.hpp"
#include "core/output/summary.hpp"

#include <limits>

namespace velum::cases {

/// One state of a body in equilibrium, SI.
struct BodyState {
  double pressure, volume;
  double deflection;   // of the middle of a disc, else the largest along the first axis; of a mesh
                       // the farthest displacement
  double stretch_max;  // largest of all stretches
  double force = 0, area = 0, penetration = 0, pressure_max = 0;  // what the seat carries
  int iterations = 0;                                             // linear solves
  double reference = std::numeric_limits<double>::quiet_NaN();    // deflection to be met
};

/// What a run of a body found.
struct BodyResult {
  std::vector<BodyState> states;
  std::vector<double> frequencies;                 // Hz, of the undeformed body
  double seat_force_max = 0, penetration_max = 0;  // of all steps of a march
};

/// Goes through the states of the scene and writes series.csv, run.h5, run.xmf, profile.csv and
/// summary.json.
/// @throws core::Divergence  no equilibrium: the state, how far it came and the likely cause
void run_body(BodyScene const& scene, std::filesystem::path const& out);

/// What the run assumes, in words.
core::Assumptions body_assumptions(BodyScene const& scene);

/// The table that the scene's reference names, made dimensionless as its scale says.
struct BodyTable {
  std::vector<double> load, deflection;
  std::vector<std::optional<double>> force;  // of the seat, over mu H a
};
BodyTable load_body_table(BodyScene const& scene);

/// Load of a state in that scale, and the length of its deflections, m.
double load_of(BodyScene const& scene, BodyState const& state);
double unit_deflection(BodyScene const& scene);

/// Row of the table with a state's load (to 1e-6); nothing where there is none.
std::optional<std::size_t> row_of(BodyScene const& scene, BodyTable const& table,
                                  BodyState const& state);

/// Errors against the reference, for the summary.
std::vector<core::Figure> compare(BodyScene const& scene, BodyTable const& table,
                                  BodyResult const& result);

}  // namespace velum::cases
