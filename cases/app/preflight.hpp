#pragma once
#include "cases/app/derived.hpp"
#include "cases/app/scene.hpp"

#include <string>
#include <vector>

namespace velum::cases {

enum class Verdict { info, ok, warn, red };

/// One line of the preflight table.
struct Row {
  std::string name;
  double value;
  std::string unit;
  Verdict verdict;
  std::string remark;  // of a warning: the smallest change that mends it
};

/// Flow: Reynolds and Mach numbers, relaxation time, compressibility.
std::vector<Row> fluid_rows(Scene const& scene, Derived const& derived);
/// Membrane and seat: cells across gap, land and thickness, mass ratio, sub-steps.
std::vector<Row> membrane_rows(Scene const& scene, Derived const& derived);
/// Steps, memory, output, time to finish at the given speed.
std::vector<Row> cost_rows(Scene const& scene, Derived const& derived, double mlups);

/// Which fidelity would do for the scene, and why: one sentence.
std::string fidelity_advice(Scene const& scene);

/// The rows as an aligned table, one line each.
std::string table(std::vector<Row> const& rows);

}  // namespace velum::cases
