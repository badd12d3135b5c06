#pragma once
#include "cases/app/body_scene.hpp"
#include "core/output/summary.hpp"

namespace velum::cases {

/// One state of a body in equilibrium, SI.
struct BodyState {
  double pressure, volume;
  double deflection;   // of the middle of a disc, else the largest along the first axis
  double stretch_max;  // largest of all stretches
  double force = 0, area = 0, penetration = 0, pressure_max = 0;  // what the seat carries
  int iterations = 0;                                             // linear solves
};

/// What a run of a body found.
struct BodyResult {
  std::vector<BodyState> states;
  std::vector<double> frequencies;  // Hz, of the undeformed body
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
};
BodyTable load_body_table(BodyScene const& scene);

/// Load and deflection of a state in that scale.
Vec2 dimensionless(BodyScene const& scene, BodyState const& state);

/// Relative error of a state's deflection; nothing where the table has no such load (to 1e-6).
std::optional<double> deflection_error(BodyScene const& scene, BodyTable const& table,
                                       BodyState const& state);

/// Errors against the reference, for the summary.
std::vector<core::Figure> compare(BodyScene const& scene, BodyTable const& table,
                                  BodyResult const& result);

}  // namespace velum::cases
