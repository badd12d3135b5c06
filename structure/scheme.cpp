#include "structure/scheme.hpp"

#include "core/check.hpp"
#include "structure/explicit_step.hpp"
#include "structure/implicit_step.hpp"
#include "structure/stable_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace velum::structure {
namespace {

/// Shortest wall time of a few calls, s.
template <class Call>
double quickest(int calls, Call const& call)
{
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < calls; ++n) {
    auto const start = Clock::now();
    call();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

}  // namespace

SchemeChoice choose_scheme(double dt, double stable, double cost_ratio, std::string const& unit)
{
  auto const check = [](double value, char const* what) {
    core::require(value > 0, fmt::format("The {} is {}; it must be above 0.", what, value));
  };
  check(dt, "step of a structure");
  check(stable, "stable step of a structure");
  check(cost_ratio, "cost of an implicit step in sub-steps");

  // more than an int holds are too many in any case
  bool const countable = dt / stable < 1e8;
  int const substeps = countable ? substeps_for(dt, stable) : 0;
  if (countable && substeps <= std::max(cost_ratio, 1.0))
    return {TimeScheme::explicit_substeps, substeps,
            fmt::format("explicit, {} sub-step{} to a step of {:.3g} {} (stable up to {:.3g} {}): "
                        "an implicit step costs as much as {:.0f}",
                        substeps, substeps == 1 ? "" : "s", dt, unit, stable, unit, cost_ratio)};
  return {TimeScheme::implicit, 1,
          fmt::format(
              "implicit, generalised-alpha, one step of {:.3g} {}: {:.3g} explicit sub-steps "
              "would be needed (stable up to {:.3g} {}), and it costs as much as {:.0f}; "
              "motion with a period below {:.3g} {} is not resolved",
              dt, unit, std::ceil(dt / (0.8 * stable)), stable, unit, cost_ratio, 20 * dt, unit)};
}

double typical_cost_ratio(Membrane const&, Rayleigh const& damping)
{
  return damping.beta > 0 ? 15 : 30;
}

double typical_cost_ratio(Sheet const&, Rayleigh const& damping)
{
  return damping.beta > 0 ? 50 : 140;
}

double coupled_cost_ratio(Membrane const&) { return 3; }

template <class Body>
double measured_cost_ratio(Body const& body, Rayleigh const& damping, double dt, double stable,
                           std::span<Load const> loads)
{
  constexpr int substeps = 20, calls = 3;
  Body moving = body;
  auto stepper = explicit_stepper(moving, damping);
  Eigen::VectorXd const none = Eigen::VectorXd::Zero(body.position.size());
  double const substep =
      quickest(
          calls,
          [&] { advance(stepper, moving, none, {}, substeps * 0.8 * stable, substeps, loads); }) /
      substeps;
  Body stepping = body;
  auto implicit = implicit_stepper(stepping, damping);
  try {
    return quickest(calls, [&] { advance(implicit, stepping, dt, loads); }) / substep;
  } catch (core::Divergence const&) {
    return std::numeric_limits<double>::infinity();
  }
}

template double measured_cost_ratio(Membrane const&, Rayleigh const&, double, double,
                                    std::span<Load const>);
template double measured_cost_ratio(Sheet const&, Rayleigh const&, double, double,
                                    std::span<Load const>);

}  // namespace velum::structure
