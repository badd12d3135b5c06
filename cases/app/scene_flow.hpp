#pragma once
#include "core/vec.hpp"

#include <string>
#include <vector>

/// What a scene may say of a flow without a membrane. SI units.
namespace velum::cases {

enum class InitialKind { rest, uniform, taylor_green, shear_layer };
enum class VelocityProfile { uniform, parabolic };
enum class ProbeKind { point, force, pressure_difference, kinetic_energy };
enum class ReferenceKind { points, taylor_green, pipe, body, dissipation, figure };

/// The flow at t = 0 (cases/app/initial_state.hpp has the formulas).
struct InitialState {
  InitialKind kind = InitialKind::rest;
  double velocity = 0;        // amplitude; uniform: along x
  double steepness = 80;      // of a shear layer: side of the box over its half thickness
  double disturbance = 0.05;  // of a shear layer: cross velocity over velocity
};

/// What a run writes over time beside its openings.
struct Probe {
  std::string name;
  ProbeKind kind;
  core::Vec3 from{};    // point; the place whose pressure counts positive
  core::Vec3 to{};      // pressure_difference: the other place
  std::string solid{};  // force: the body
};

/// What a run compares its result with.
struct Reference {
  ReferenceKind kind;
  std::string file{};        // points, body, dissipation: a table beside the scene
  double length = 0;         // of the Reynolds number; pipe: the radius
  std::string energy{};      // dissipation: name of a probe
  std::string force{};       // body: name of a probe
  std::string difference{};  // body: name of a probe, or empty
  std::string figure{};      // figure: one of summary.json
  double value = 0;          // figure: what it should be, in the figure's own SI unit
  double scale = 0;          // figure: what its error is a share of
};

/// What `velum chart` sweeps of this scene.
struct Sweep {
  std::vector<double> dx;
};

}  // namespace velum::cases
