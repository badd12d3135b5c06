#pragma once
#include "cases/app/history.hpp"
#include "cases/app/sample.hpp"
#include "cases/app/scene.hpp"
#include "core/output/summary.hpp"
#include "core/units.hpp"

#include <optional>
#include <string>
#include <vector>

namespace velum::cases {

/// A published or computed velocity at a place, SI.
struct ReferencePoint {
  Vec3 at;
  std::optional<double> u, v, w;
};

/// Bounds in which a figure of the run should lie.
struct ReferenceBound {
  std::string figure;
  double low, high;
};

/// What the file of a reference holds for the Reynolds number of the scene.
struct ReferenceData {
  std::vector<ReferencePoint> points;
  std::vector<ReferenceBound> bounds;
  std::string note;  // what is compared with, or why nothing is
};

/// Reads the file of the scene's reference and keeps the rows of its Reynolds number U L/nu (U from
/// flow_velocity(), L the reference's length) and, where the file has times, of the scene's end.
/// points: columns x, y, [z] over L and u, v, [w] over U, empty where not given; [time] over L/U.
/// body, dissipation: columns figure, low, high.
/// @throws core::InputError  the file is not of that form
ReferenceData load_reference(Scene const& scene);

/// The end of a run as a reference sees it.
struct Result {
  Scene const& scene;
  core::Units const& units;
  Sampled const& flow;
  History const& history;
  double time;
};

/// The errors of a run, for its summary. Names end in _error or begin with error_.
std::vector<core::Figure> compare(ReferenceData const& data, Result const& result);

/// Adds the error |x - value| / scale of the figure x that a scene's reference of kind "figure"
/// names. Where the run has no such figure, which is known at its end only, the summary and a
/// warning say so. Nothing where the scene has another reference or none.
void compare_figure(Scene const& scene, core::Summary& summary);

/// Name of the figure by which runs of the scene are ranked: error_l2, or the first bound's error.
/// Empty where the file has nothing for the scene's Reynolds number.
std::string error_key(Scene const& scene, ReferenceData const& data);

// One function for each kind of reference.

/// Values at points, as error_l2 (root of the summed squares over that of the reference's) and
/// error_max (over the flow velocity).
std::vector<core::Figure> compare_points(ReferenceData const& data, Result const& result);
/// The exact decay of initial_flow(): error_l2 over all cells, error_max over the amplitude, and
/// viscosity_error from the decay of the amplitude.
std::vector<core::Figure> compare_taylor_green(Result const& result);
/// Hagen-Poiseuille flow u = g (R^2 - r^2) / 4 nu: error_l2 over the section, error_max over the
/// velocity on the axis. The axis is y = z = 0.
std::vector<core::Figure> compare_pipe(Result const& result);
/// Coefficients 2 F / (rho U^2 A), A = L per depth or pi L^2/4, at the end or, where the lift
/// oscillates, over its last periods with the Strouhal number L/(U T); the pressure difference at
/// the end or half a period after the largest lift. With each figure that has bounds, its relative
/// distance from their middle and whether it lies within.
std::vector<core::Figure> compare_body(ReferenceData const& data, Result const& result);
/// Largest rate at which the mean kinetic energy falls, dissipation_peak over U^3/L, and its time,
/// dissipation_time over L/U. With each figure that has bounds its error as in compare_body().
std::vector<core::Figure> compare_dissipation(ReferenceData const& data, Result const& result);

/// Relative distance of each figure from the middle of its bounds, and whether it lies within.
std::vector<core::Figure> errors_of(ReferenceData const& data,
                                    std::vector<core::Figure> const& figures);

}  // namespace velum::cases
